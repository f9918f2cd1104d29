// Goes through the map.
#include "tile_search.h"

#include <algorithm>

namespace talus {

std::size_t count_tile(const TileMap& map, TileNumber tile, Within within) {
  const CellRect all{0, 0, map.width(), map.height()};
  const auto part = shared(within.value_or(all), all);
  if (!part) return 0;
  std::size_t count = 0;
  for (int y = part->y; y < part->y + part->h; ++y) {
    for (int x = part->x; x < part->x + part->w; ++x) count += map.tile_at({x, y}) == tile ? 1 : 0;
  }
  return count;
}

std::optional<Cell> find_tile(const TileMap& map, TileNumber tile, std::optional<Cell> from,
                              FindDirection direction, Within within) {
  const auto size = static_cast<std::int64_t>(map.cells().size());
  const std::int64_t step = direction == FindDirection::next ? 1 : -1;
  std::int64_t at = direction == FindDirection::next ? size - 1 : 0;
  if (from && map.contains(*from)) at = static_cast<std::int64_t>(from->y) * map.width() + from->x;
  for (std::int64_t i = 0; i < size; ++i) {
    at = (at + step + size) % size;
    if (map.cells().tiles()[static_cast<std::size_t>(at)] != tile) continue;
    const Cell cell{static_cast<int>(at % map.width()), static_cast<int>(at / map.width())};
    if (!within || within->contains(cell)) return cell;
  }
  return std::nullopt;
}

}  // namespace talus
