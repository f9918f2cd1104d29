// The ground of a level, compiled for collision.
#pragma once

#include <optional>
#include <string>

#include "../collision/terrain.h"
#include "level.h"

namespace talus {

// What the terrain of a level is made of. Refers to the level's map, which must stay while it is used. Shapes
// and curves that cannot be used are left out; lint tells of them.
TerrainSource ground_of(const Level& level);

// The solvers article and bump make a box of each tile of ground, which takes some hundred bytes. A level
// with more tiles than this has no ground for them.
inline constexpr std::size_t kMaxBoxedTiles = std::size_t{1} << 21;
// That it has, one sentence without a subject; nothing: it has not, or its solver needs no boxes.
std::optional<std::string> boxes_problem(const Level& level);

}  // namespace talus
