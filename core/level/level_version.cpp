// Versions of a level, which share equal parts.
#include "level_version.h"

#include <algorithm>
#include <utility>

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

LevelVersion::Row row_of(const TileMap& map, int y) {
  const auto begin = map.cells().begin() + static_cast<std::ptrdiff_t>(y) * map.width();
  return {begin, begin + map.width()};
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

bool is_row(const TileMap& map, int y, const LevelVersion::Row& row) {
  const auto begin = map.cells().begin() + static_cast<std::ptrdiff_t>(y) * map.width();
  return std::equal(begin, begin + map.width(), row.begin(), row.end());
}

}  // namespace

LevelVersion version_of(const Level& level, const LevelVersion* before) {
  static const LevelVersion kNone;
  const LevelVersion& old = before != nullptr ? *before : kNone;
  LevelVersion version{shared_part(tiles_of(level), old.tiles),
                       shared_part(level.curves, old.curves),
                       shared_part(level.spawns, old.spawns),
                       level.tuning,
                       level.map.tile_size(),
                       {}};
  version.rows.reserve(static_cast<std::size_t>(level.map.height()));
  for (int y = 0; y < level.map.height(); ++y) {
    const auto at = static_cast<std::size_t>(y);
    const bool same = at < old.rows.size() && is_row(level.map, y, *old.rows[at]);
    version.rows.push_back(same ? old.rows[at]
                                : std::make_shared<const LevelVersion::Row>(row_of(level.map, y)));
  }
  return version;
}

LevelVersion version_of(const Level& level, const LevelVersion& before, std::span<const Cell> changed) {
  LevelVersion version = before;
  version.spawns = shared_part(level.spawns, before.spawns);
  version.tuning = level.tuning;
  for (const Cell cell : changed) {
    auto& row = version.rows[static_cast<std::size_t>(cell.y)];
    if (!is_row(level.map, cell.y, *row))
      row = std::make_shared<const LevelVersion::Row>(row_of(level.map, cell.y));
  }
  return version;
}

std::size_t memory_of(const LevelVersion& version, const LevelVersion* before) {
  constexpr std::size_t kRow = 48;  // bytes of a row besides its tiles
  static const LevelVersion kNone;
  const LevelVersion& old = before != nullptr ? *before : kNone;
  std::size_t bytes = sizeof(LevelVersion) + version.rows.size() * sizeof(version.rows[0]);
  if (version.tiles != old.tiles) bytes += memory_of(*version.tiles);
  if (version.curves != old.curves) bytes += memory_of(*version.curves);
  if (version.spawns != old.spawns) bytes += memory_of(*version.spawns);
  for (std::size_t y = 0; y < version.rows.size(); ++y) {
    if (y >= old.rows.size() || version.rows[y] != old.rows[y])
      bytes += kRow + version.rows[y]->size() * sizeof(TileNumber);
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
  level.spawns = *version.spawns;
  level.tuning = version.tuning;
  level.map = TileMap(static_cast<int>(version.rows.front()->size()), static_cast<int>(version.rows.size()),
                      version.tile_size);
  auto out = level.map.cells().begin();
  for (const auto& row : version.rows) out = std::copy(row->begin(), row->end(), out);
}

Level level_of(const LevelVersion& version) {
  Level level;
  put_version(version, level);
  return level;
}

std::optional<std::vector<Cell>> changed_cells(const LevelVersion& a, const LevelVersion& b,
                                               std::size_t most) {
  const auto same = [](const auto& x, const auto& y) { return x == y || *x == *y; };
  const bool only_cells = a.tuning == b.tuning && same(a.tiles, b.tiles) && same(a.curves, b.curves) &&
                          same(a.spawns, b.spawns) && a.tile_size == b.tile_size &&
                          a.rows.size() == b.rows.size() && a.rows.front()->size() == b.rows.front()->size();
  if (!only_cells) return std::nullopt;
  std::vector<Cell> cells;
  for (std::size_t y = 0; y < a.rows.size(); ++y) {
    if (a.rows[y] == b.rows[y]) continue;
    for (std::size_t x = 0; x < a.rows[y]->size(); ++x) {
      if ((*a.rows[y])[x] == (*b.rows[y])[x]) continue;
      if (cells.size() == most) return std::nullopt;
      cells.push_back({static_cast<int>(x), static_cast<int>(y)});
    }
  }
  return cells;
}

}  // namespace talus
