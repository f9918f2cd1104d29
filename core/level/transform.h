// A level mirrored or moved as a whole, with everything that its physics depends on. What is only drawn is
// left out.
#pragma once

#include <talus/level/level.h>

namespace talus {

// Left and right changed about the middle of the map.
Level mirrored(const Level& level);

// Moved right and down by whole tiles, >= 0, in a map that has grown by as much; its size must stay within
// is_terrain_size (asserted).
Level moved(const Level& level, int columns, int rows);
Curve moved(const Curve& curve, Vec2 by);  // by: px

}  // namespace talus
