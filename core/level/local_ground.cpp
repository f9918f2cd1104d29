// Compiles a window of the map.
#include "local_ground.h"

#include <algorithm>
#include <cmath>

namespace talus {

LocalGround ground_around(const Level& level, const Rect& box, int cells) {
  const TileMap& map = level.map;
  const int margin = cells + kMaxShapeTiles;  // slopes that begin further away may reach here
  const auto cell = [margin](double px, int side, int by, int count) {
    return static_cast<int>(
        std::clamp(std::floor(px / side) + by * margin, 0.0, static_cast<double>(count - 1)));
  };
  const auto [tile_width, tile_height] = map.tile_size();
  const Cell first{cell(box.x, tile_width, -1, map.width()), cell(box.y, tile_height, -1, map.height())};
  const Cell last{cell(box.right(), tile_width, 1, map.width()),
                  cell(box.bottom(), tile_height, 1, map.height())};
  std::vector<std::uint8_t> tiles;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) tiles.push_back(map.at({x, y}));
  }
  TerrainSource source;
  source.width = last.x - first.x + 1;
  source.height = last.y - first.y + 1;
  source.tile = map.tile_size();
  source.cells = tiles;
  for (int tile = 0; tile < kTileCount; ++tile) {
    TileShape shape = shape_of_tile(level, static_cast<std::uint8_t>(tile));
    if (!problem_of(shape, source.tile)) source.shapes[static_cast<std::size_t>(tile)] = std::move(shape);
  }
  return {Terrain(source), map.corner_of(first)};
}

}  // namespace talus
