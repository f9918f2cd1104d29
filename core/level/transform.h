// Mirrors, moves or scales a whole level, with all that its physics depends on. Parts that are only drawn are
// left out.
#pragma once

#include <talus/level/level.h>

namespace talus {

// Swaps left and right about the middle of the map.
Level mirrored(const Level& level);

// Moves a level right and down by whole tiles, 0 or more. The map grows by as much; its size must satisfy
// is_terrain_size (asserted).
Level moved(const Level& level, int columns, int rows);
Curve moved(const Curve& curve, Vec2 by);  // by: px

// The same level with tiles, and all that has a length or speed, `factor` times as large. The tiles and the
// map must stay within their limits (asserted); the tuning may leave its ranges.
Level scaled(const Level& level, int factor);
Curve scaled(const Curve& curve, int factor);

}  // namespace talus
