// Versions of a level, which share equal parts.
#include "level_version.h"

#include <algorithm>
#include <set>
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

using Cells = std::vector<TileNumber>;

LevelVersion::Row row_of(const Cells& cells, int width, int y) {
  const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(y) * width;
  return {begin, begin + width};
}

std::size_t memory_of(const LevelVersion::Tiles& tiles) {
  return sizeof(LevelVersion::Tiles) + tiles.flags.size() * (1 + sizeof(TileShape));
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

bool is_row(const Cells& cells, int width, int y, const LevelVersion::Row& row) {
  const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(y) * width;
  return std::equal(begin, begin + width, row.begin(), row.end());
}

// before: the rows to share equal ones with; may be fewer, or of another length.
LevelVersion::Layer layer_of(const Level& level, int index,
                             std::span<const std::shared_ptr<const LevelVersion::Row>> before) {
  LevelVersion::Layer layer{level.layers.list[static_cast<std::size_t>(index)], {}};
  layer.looks.cells = nullptr;
  const Cells& cells = level.cells_of(index);
  const int width = level.map.width();
  layer.rows.reserve(static_cast<std::size_t>(level.map.height()));
  for (int y = 0; y < level.map.height(); ++y) {
    const auto at = static_cast<std::size_t>(y);
    const bool same = at < before.size() && is_row(cells, width, y, *before[at]);
    layer.rows.push_back(same ? before[at]
                              : std::make_shared<const LevelVersion::Row>(row_of(cells, width, y)));
  }
  return layer;
}

Cells cells_of(const LevelVersion::Layer& layer) {
  Cells cells;
  cells.reserve(layer.rows.size() * layer.rows.front()->size());
  for (const auto& row : layer.rows) cells.insert(cells.end(), row->begin(), row->end());
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
                       {},
                       level.layers.chosen};
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const auto at = static_cast<std::size_t>(layer);
    version.layers.push_back(at < old.layers.size() ? layer_of(level, layer, old.layers[at].rows)
                                                    : layer_of(level, layer, {}));
  }
  return version;
}

LevelVersion version_of(const Level& level, const LevelVersion& before, std::span<const Cell> changed) {
  LevelVersion version = before;
  version.spawns = shared_part(level.spawns, before.spawns);
  version.tuning = level.tuning;
  version.chosen_layer = level.layers.chosen;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const Cells& cells = level.cells_of(layer);
    for (const Cell cell : changed) {
      auto& row = version.layers[static_cast<std::size_t>(layer)].rows[static_cast<std::size_t>(cell.y)];
      if (!is_row(cells, level.map.width(), cell.y, *row))
        row = std::make_shared<const LevelVersion::Row>(row_of(cells, level.map.width(), cell.y));
    }
  }
  return version;
}

std::size_t memory_of(const LevelVersion& version, const LevelVersion* before) {
  constexpr std::size_t kRow = 48;  // bytes of a row besides its tiles
  static const LevelVersion kNone;
  const LevelVersion& old = before != nullptr ? *before : kNone;
  std::size_t bytes = sizeof(LevelVersion);
  if (version.tiles != old.tiles) bytes += memory_of(*version.tiles);
  if (version.curves != old.curves) bytes += memory_of(*version.curves);
  if (version.objects != old.objects) bytes += size_of(*version.objects);
  if (version.spawns != old.spawns) bytes += memory_of(*version.spawns);
  for (std::size_t layer = 0; layer < version.layers.size(); ++layer) {
    const auto& rows = version.layers[layer].rows;
    static const std::vector<std::shared_ptr<const LevelVersion::Row>> kNoRows;
    const auto& old_rows = layer < old.layers.size() ? old.layers[layer].rows : kNoRows;
    bytes += sizeof(LevelVersion::Layer) + rows.size() * sizeof(rows[0]);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      if (y >= old_rows.size() || rows[y] != old_rows[y])
        bytes += kRow + rows[y]->size() * sizeof(TileNumber);
    }
  }
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
  const auto& rows = version.layers.front().rows;
  level.map =
      TileMap(static_cast<int>(rows.front()->size()), static_cast<int>(rows.size()), version.tile_size);
  level.layers = {{}, version.chosen_layer};
  for (const LevelVersion::Layer& layer : version.layers) {
    level.layers.list.push_back(layer.looks);
    if (level.layers.count() - 1 == version.chosen_layer)
      level.map.cells() = cells_of(layer);
    else
      level.layers.list.back().cells = std::make_shared<const Cells>(cells_of(layer));
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
    return x.looks.is_ground == y.looks.is_ground && x.rows.size() == y.rows.size() &&
           x.rows.front()->size() == y.rows.front()->size();
  };
  const bool only_cells =
      a.tuning == b.tuning && same(a.tiles, b.tiles) && same(a.curves, b.curves) &&
      same(a.objects, b.objects) && same(a.spawns, b.spawns) && a.tile_size == b.tile_size &&
      std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), same_layer);
  if (!only_cells) return std::nullopt;
  std::set<std::pair<int, int>> cells;  // row, column
  for (std::size_t layer = 0; layer < a.layers.size(); ++layer) {
    const auto &ours = a.layers[layer].rows, &theirs = b.layers[layer].rows;
    for (std::size_t y = 0; y < ours.size(); ++y) {
      if (ours[y] == theirs[y]) continue;
      for (std::size_t x = 0; x < ours[y]->size(); ++x) {
        if ((*ours[y])[x] == (*theirs[y])[x]) continue;
        cells.emplace(static_cast<int>(y), static_cast<int>(x));
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
