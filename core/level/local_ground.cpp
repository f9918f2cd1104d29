// Compiles a window of the map.
#include "local_ground.h"

#include <algorithm>
#include <cmath>

#include <talus/level/ground.h>

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
  std::vector<TileNumber> tiles;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) tiles.push_back(map.at({x, y}));
  }
  TerrainSource source;
  source.width = last.x - first.x + 1;
  source.height = last.y - first.y + 1;
  source.tile = map.tile_size();
  source.cells = tiles;
  source.shapes = usable_shapes(level);
  return {Terrain(source), map.corner_of(first)};
}

}  // namespace talus
