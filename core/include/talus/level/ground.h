// The ground of a level, compiled for collision.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/terrain.h>
#include <talus/level/level.h>

namespace talus {

// What the terrain of a level is made of. Refers to the level's map, which must stay while it is used. Shapes
// and curves that cannot be used are left out; lint tells of them.
TerrainSource ground_of(const Level& level);

// The solvers article and bump make boxes of each tile of ground, which take some hundred bytes each, and
// exact keeps the lines of slopes and the like by cell, which take as much. A level with more of them than
// this has no ground for its solver.
inline constexpr std::size_t kMaxGroundBoxes = std::size_t{1} << 21;  // for article and bump
inline constexpr std::size_t kMaxGroundLines = std::size_t{1} << 24;  // for exact

// About how many lines a shape has, counted again in each cell that they pass. 0 of a full tile, which needs
// none, and of what is no shape or none that can be used.
std::size_t ground_lines(const TileShape& shape);
// Of all tiles of the map together.
std::size_t ground_lines(const Level& level);

// That a level has too much ground for its solver, one sentence without a subject; nothing: it has not.
std::optional<std::string> ground_problem(const Level& level);

}  // namespace talus
