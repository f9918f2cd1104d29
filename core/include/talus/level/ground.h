// The ground of a level, compiled for collision.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/terrain.h>
#include <talus/level/level.h>

namespace talus {

// The parts of a level's terrain. Refers to the level's map, which must stay alive meanwhile. It must have no
// other layer of tiles, and no turned ones (both asserted). Invalid shapes and curves are left out; the lint
// reports them.
TerrainSource ground_of(const Level& level);

// The terrain of a level with any layers.
Terrain terrain_of(const Level& level);

// The shape of each tile of a level, of its own or of its flags, by number. Invalid shapes are of kind none.
std::vector<TileShape> usable_shapes(const Level& level);

// Limits for the ground of a level. The solvers article and bump make boxes of each tile of ground, which
// take some hundred bytes each. exact keeps lines, such as those of slopes, by cell, which take as much. A
// level with more than this has no ground for its solver.
inline constexpr std::size_t kMaxGroundBoxes = std::size_t{1} << 21;  // for article and bump
inline constexpr std::size_t kMaxGroundLines = std::size_t{1} << 24;  // for exact

// About how many lines a shape has; a line counts again in each cell that it crosses. 0 for a full tile,
// which needs no lines, and for a shape that is invalid for tiles of that size.
std::size_t ground_lines(const TileShape& shape, TileSize tile);
// For all tiles of the map together.
std::size_t ground_lines(const Level& level);

// Says that a level has too much ground for its solver, or too many different stacks of tiles in its layers,
// as a sentence without its subject; nothing if it has not.
std::optional<std::string> ground_problem(const Level& level);

}  // namespace talus
