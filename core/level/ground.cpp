#include "ground.h"

namespace talus {

TerrainSource ground_of(const Level& level) {
  TerrainSource source;
  source.width = level.map.width();
  source.height = level.map.height();
  source.cells = level.map.cells();
  for (int tile = 0; tile < kTileCount; ++tile) {
    TileShape shape = shape_of_tile(level, static_cast<std::uint8_t>(tile));
    if (!problem_of(shape)) source.shapes[tile] = std::move(shape);
  }
  for (const LevelCurve& c : level.curves) {
    if (!problem_of(c.curve, level.map)) source.curves.push_back(c.curve);
  }
  return source;
}

}  // namespace talus
