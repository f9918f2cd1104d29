#include "displaced_tile.h"

#include <algorithm>

#include "../tiled/tiled_map.h"

namespace talus {

TileNumber displaced_tile(const Level& level) {
  // Tilesets without places have new numbers.
  const bool has_place = !level.tilesets.empty() && level.tilesets.front().first == 0 &&
                         level.tilesets.front().columns > 1 && level.tilesets.front().count > 1;
  if (level.tiled == nullptr || !has_place) return 0;
  const std::vector<std::uint32_t>& tiles = level.tiled->frame.tiles;
  // By its neighbour at the right, of the same tileset, which is not turned.
  const bool is_displaced = level.tiled->frame.is_0_empty && tiles.size() > 1 && tiles[1] > 1 &&
                            tiles[1] < kTiledFlipXY && tiles[0] != tiles[1] - 1;
  if (!is_displaced) return 0;
  const auto found = std::find(tiles.begin(), tiles.end(), tiles[1] - 1);
  const auto number = found - tiles.begin();
  return found == tiles.end() || number >= level.tile_count() ? TileNumber{0}
                                                              : static_cast<TileNumber>(number);
}

}  // namespace talus
