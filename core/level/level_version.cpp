// Versions of a level, which share equal parts.
#include "level_version.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include <talus/level/limits.h>

namespace talus {
namespace {

// Returns the part of the version before, if it is equal.
template <class Part>
std::shared_ptr<const Part> shared_part(Part part, const std::shared_ptr<const Part>& before) {
  if (before != nullptr && *before == part) return before;
  return std::make_shared<const Part>(std::move(part));
}

LevelVersion::Tiles tiles_of(const Level& level) {
  return {level.sheet(SheetId::tiles).flags, level.roles, level.tile_shapes, level.flag_shapes};
}

std::size_t first_in_row(int width, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
}

std::span<const TileNumber> tiles_in(const MapCells& cells, std::size_t first, int width) {
  return std::span(cells.tiles()).subspan(first, static_cast<std::size_t>(width));
}

// The turns of cells; none if no cell of the layer is turned.
std::span<const TileTurn> turns_in(const MapCells& cells, std::size_t first, int width) {
  if (!cells.has_turned()) return {};
  return std::span(cells.turns()).subspan(first, static_cast<std::size_t>(width));
}

// A row that shares nothing.
LevelVersion::Row copied_row(const MapCells& cells, int width, int y) {
  const std::size_t first = first_in_row(width, y);
  const auto tiles = tiles_in(cells, first, width);
  const auto turns = turns_in(cells, first, width);
  std::vector<TileNumber> copy(tiles.begin(), tiles.end());
  if (turns.empty()) return {std::make_shared<const MapCells>(std::move(copy))};
  return {std::make_shared<const MapCells>(std::move(copy), std::vector(turns.begin(), turns.end()))};
}

std::size_t memory_of(const LevelVersion::Tiles& tiles) {
  return sizeof(LevelVersion::Tiles) + tiles.flags.size() * (sizeof(FlagSet) + sizeof(TileShape));
}

std::size_t memory_of(const std::vector<Spawn>& spawns) {
  std::size_t bytes = spawns.size() * sizeof(Spawn);
  for (const Spawn& spawn : spawns) bytes += spawn.name.size() + spawn.extra.size();
  return bytes;
}

std::size_t memory_of(const std::vector<LevelCurve>& curves) {
  std::size_t bytes = curves.size() * sizeof(LevelCurve);
  for (const LevelCurve& curve : curves) {
    bytes += curve.name.size() + curve.extra.size();
    if (const auto* line = std::get_if<Polyline>(&curve.curve.form))
      bytes += line->ys.size() * sizeof(double);
  }
  return bytes;
}

bool is_row(const MapCells& cells, int width, int y, const LevelVersion::Row& row) {
  const std::size_t first = first_in_row(width, y);
  if (row.cells.get() == &cells && row.first == first) return true;
  if (!std::ranges::equal(tiles_in(cells, first, width), tiles_in(*row.cells, row.first, width)))
    return false;
  const auto ours = turns_in(cells, first, width), theirs = turns_in(*row.cells, row.first, width);
  const auto is_none = [](TileTurn turn) { return turn == TileTurn::none; };
  if (ours.empty()) return std::ranges::all_of(theirs, is_none);
  if (theirs.empty()) return std::ranges::all_of(ours, is_none);
  return std::ranges::equal(ours, theirs);
}

// The cells of a layer as a version may keep them: those of the level, or a copy of those that its map holds.
std::shared_ptr<const MapCells> kept_cells(const Level& level, int index) {
  const auto& cells = level.layers.list[static_cast<std::size_t>(index)].cells;
  if (index != level.layers.chosen && cells != nullptr) return cells;
  return std::make_shared<const MapCells>(level.cells_of(index));
}

// Cells that several rows share count once. before: null if there is none.
std::size_t memory_of(const LevelVersion::Layer& layer, const LevelVersion::Layer* before) {
  constexpr std::size_t kCells = 96;  // bytes of cells besides their tiles and turns
  std::size_t bytes = sizeof(layer) + layer.rows.size() * sizeof(layer.rows[0]);
  const MapCells* last = nullptr;
  for (std::size_t y = 0; y < layer.rows.size(); ++y) {
    const MapCells* cells = layer.rows[y].cells.get();
    const bool is_old = before != nullptr && y < before->rows.size() && layer.rows[y] == before->rows[y];
    if (is_old || cells == last) continue;
    bytes += kCells + cells->tiles().size() * sizeof(TileNumber) + cells->turns().size() * sizeof(TileTurn);
    last = cells;
  }
  return bytes;
}

// before: the rows to share equal ones with; may be fewer. width: cells, of each of them.
LevelVersion::Layer layer_of(const Level& level, int index, std::span<const LevelVersion::Row> before,
                             int width) {
  LevelVersion::Layer layer{level.layers.list[static_cast<std::size_t>(index)], {}};
  layer.looks.cells = nullptr;
  if (width != level.map.width()) before = {};
  const MapCells& cells = level.cells_of(index);
  std::shared_ptr<const MapCells> kept;  // made when the first row needs it
  layer.rows.reserve(static_cast<std::size_t>(level.map.height()));
  for (int y = 0; y < level.map.height(); ++y) {
    const auto at = static_cast<std::size_t>(y);
    if (at < before.size() && is_row(cells, level.map.width(), y, before[at])) {
      layer.rows.push_back(before[at]);
      continue;
    }
    if (kept == nullptr) kept = kept_cells(level, index);
    layer.rows.push_back({kept, first_in_row(level.map.width(), y)});
  }
  return layer;
}

MapCells cells_of(const LevelVersion::Layer& layer, int width) {
  std::vector<TileNumber> tiles;
  tiles.reserve(layer.rows.size() * static_cast<std::size_t>(width));
  for (const LevelVersion::Row& row : layer.rows) {
    const auto found = tiles_in(*row.cells, row.first, width);
    tiles.insert(tiles.end(), found.begin(), found.end());
  }
  MapCells cells(std::move(tiles));
  std::size_t first = 0;
  for (const LevelVersion::Row& row : layer.rows) {
    for (int x = 0; row.cells->has_turned() && x < width; ++x)
      cells.set(first + static_cast<std::size_t>(x), row.at(x));
    first += static_cast<std::size_t>(width);
  }
  return cells;
}

}  // namespace

LevelVersion version_of(const Level& level, const LevelVersion* before) {
  static const LevelVersion kNone;
  const LevelVersion& old = before != nullptr ? *before : kNone;
  LevelVersion version{shared_part(tiles_of(level), old.tiles),
                       shared_part(level.curves, old.curves),
                       shared_part(level.objects, old.objects),
                       shared_part(level.spawns, old.spawns),
                       level.tuning,
                       level.map.tile_size(),
                       level.map.width(),
                       {},
                       level.layers.chosen,
                       level.layers.groups};
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const auto at = static_cast<std::size_t>(layer);
    const bool is_old = at < old.layers.size();
    version.layers.push_back(is_old ? layer_of(level, layer, old.layers[at].rows, old.width)
                                    : layer_of(level, layer, {}, 0));
  }
  return version;
}

LevelVersion version_of(const Level& level, const LevelVersion& before, std::span<const Cell> changed) {
  LevelVersion version = before;
  version.spawns = shared_part(level.spawns, before.spawns);
  version.tuning = level.tuning;
  version.chosen_layer = level.layers.chosen;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const MapCells& cells = level.cells_of(layer);
    for (const Cell cell : changed) {
      auto& row = version.layers[static_cast<std::size_t>(layer)].rows[static_cast<std::size_t>(cell.y)];
      if (!is_row(cells, version.width, cell.y, row)) row = copied_row(cells, version.width, cell.y);
    }
  }
  return version;
}

std::size_t memory_of(const LevelVersion& version, const LevelVersion* before) {
  static const LevelVersion kNone;
  const LevelVersion& old = before != nullptr ? *before : kNone;
  std::size_t bytes = sizeof(LevelVersion) + version.groups.size() * sizeof(LayerGroup);
  if (version.tiles != old.tiles) bytes += memory_of(*version.tiles);
  if (version.curves != old.curves) bytes += memory_of(*version.curves);
  if (version.objects != old.objects) bytes += size_of(*version.objects);
  if (version.spawns != old.spawns) bytes += memory_of(*version.spawns);
  for (std::size_t layer = 0; layer < version.layers.size(); ++layer)
    bytes += memory_of(version.layers[layer], layer < old.layers.size() ? &old.layers[layer] : nullptr);
  return bytes;
}

void put_version(const LevelVersion& version, Level& level) {
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.flags = version.tiles->flags;
  sheet.images.resize(sheet.flags.size());
  level.roles = version.tiles->roles;
  level.tile_shapes = version.tiles->tile_shapes;
  level.flag_shapes = version.tiles->flag_shapes;
  level.curves = *version.curves;
  level.objects = *version.objects;
  level.spawns = *version.spawns;
  level.tuning = version.tuning;
  level.map = TileMap(version.width, static_cast<int>(version.layers.front().rows.size()), version.tile_size);
  level.layers = {{}, version.chosen_layer, level.layers.order, version.groups};
  for (const LevelVersion::Layer& layer : version.layers) {
    level.layers.list.push_back(layer.looks);
    if (level.layers.count() - 1 == version.chosen_layer)
      level.map.cells() = cells_of(layer, version.width);
    else
      level.layers.list.back().cells = std::make_shared<const MapCells>(cells_of(layer, version.width));
  }
}

Level level_of(const LevelVersion& version) {
  Level level;
  put_version(version, level);
  return level;
}

std::optional<std::vector<Cell>> changed_cells(const LevelVersion& a, const LevelVersion& b,
                                               std::size_t most) {
  const auto same = [](const auto& x, const auto& y) { return x == y || *x == *y; };
  const auto same_layer = [](const LevelVersion::Layer& x, const LevelVersion::Layer& y) {
    return x.looks.is_ground == y.looks.is_ground && x.rows.size() == y.rows.size();
  };
  const bool only_cells =
      a.tuning == b.tuning && same(a.tiles, b.tiles) && same(a.curves, b.curves) &&
      same(a.objects, b.objects) && same(a.spawns, b.spawns) && a.tile_size == b.tile_size &&
      a.width == b.width && a.groups == b.groups &&
      std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), same_layer);
  if (!only_cells) return std::nullopt;
  std::set<std::pair<int, int>> cells;  // row, column
  for (std::size_t layer = 0; layer < a.layers.size(); ++layer) {
    const auto &ours = a.layers[layer].rows, &theirs = b.layers[layer].rows;
    for (std::size_t y = 0; y < ours.size(); ++y) {
      if (ours[y] == theirs[y]) continue;
      for (int x = 0; x < a.width; ++x) {
        if (ours[y].at(x) == theirs[y].at(x)) continue;
        cells.emplace(static_cast<int>(y), x);
        if (cells.size() > most) return std::nullopt;
      }
    }
  }
  std::vector<Cell> list;
  list.reserve(cells.size());
  for (const auto& [y, x] : cells) list.push_back({x, y});
  return list;
}

}  // namespace talus
