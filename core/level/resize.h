// The map of a level made larger or smaller, or shifted within its size, with all that lies on it.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/level/level.h>

namespace talus {

struct MapFrame {
  int width = kTicMapWidth;  // cells, of the new map; as is_terrain_size says (asserted by resized())
  int height = kTicMapHeight;
  Cell shift{0, 0};   // cells, from where something is on the old map to its place on the new one
  bool wrap = false;  // what leaves at one side comes in at the other, as far as the larger of the two sizes
  friend bool operator==(const MapFrame&, const MapFrame&) = default;
};

struct ResizedMap {
  TileMap map;
  std::vector<Spawn> spawns;
  std::vector<LevelCurve> curves;
  // What has no place on the new map: cells with another tile than 0, bodies wholly beside it, curves that
  // reach beyond its edges.
  std::size_t lost_tiles = 0, lost_spawns = 0, lost_curves = 0;
  bool loses() const { return lost_tiles + lost_spawns + lost_curves > 0; }
};

// Curves that were unusable before are kept, and bodies that lay wholly beside the map. Bodies and curves
// wrap as a whole.
ResizedMap resized(const Level& level, const MapFrame& frame);

}  // namespace talus
