// The ground around a box, for questions that do not need the whole map.
#pragma once

#include <talus/collision/terrain.h>
#include <talus/level/level.h>

namespace talus {

struct LocalGround {
  Terrain terrain;  // made of tiles only: free curves are thin and have no inside
  Vec2 corner;      // px, in the level, of the terrain's corner
  Rect to_local(Rect box) const { return {box.x - corner.x, box.y - corner.y, box.w, box.h}; }
};

// cells: the ground is right up to this many cells around the box, 0..1024.
LocalGround ground_around(const Level& level, const Rect& box, int cells);

}  // namespace talus
