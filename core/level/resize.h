// Makes the map of a level larger or smaller, or shifts it within its size, with everything on it.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/level/level.h>

namespace talus {

struct MapFrame {
  int width = kTicMapWidth;  // cells of the new map; is_terrain_size must allow it (asserted by resized())
  int height = kTicMapHeight;
  Cell shift{0, 0};   // cells, from the old place of something to the new one
  bool wrap = false;  // what leaves at one side comes in at the other, within the larger of the two sizes
  friend bool operator==(const MapFrame&, const MapFrame&) = default;
};

struct ResizedMap {
  TileMap map;
  TileLayers layers;
  std::vector<Spawn> spawns;
  std::vector<LevelCurve> curves;
  std::vector<ObjectLayer> objects;  // all of them, and none wraps
  // What has no place on the new map: cells of any layer with a tile other than 0, bodies wholly beside it,
  // curves that reach beyond its edges.
  std::size_t lost_tiles = 0, lost_spawns = 0, lost_curves = 0;
  bool loses() const { return lost_tiles + lost_spawns + lost_curves > 0; }
};

// Curves that were unusable before are kept, and so are bodies that lay wholly beside the map. Bodies and
// curves wrap as a whole.
ResizedMap resized(const Level& level, const MapFrame& frame);

}  // namespace talus
