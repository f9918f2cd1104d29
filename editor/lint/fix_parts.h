// The parts of the fixes, by what they are about; for fixes.cpp alone. Each appends edits, the best first.
#pragma once

#include <string>
#include <vector>

#include "fixes.h"
#include "lint_tiles.h"

namespace talus {

// Of slopes that lack a half, a flag or a picture, or that meet what they should not.
void fix_slope(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out);
// Of floors and ceilings that jump, and of floors that are too steep.
void fix_seam(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out);
void fix_steepness(const Level& level, const Problem& problem, std::vector<Edit>& out);
// Of flags, pictures, shapes, roles, curves and the solver.
void fix_tile(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out);
void fix_level(const Level& level, const Problem& problem, std::vector<Edit>& out);
// Of spawns and balls.
void fix_start(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out);

// "tile 12", in labels.
inline std::string tile_text(int tile) { return "tile " + std::to_string(tile); }

// An edit of one cell that has another tile.
Edit put_tile(const Level& level, Cell cell, std::uint8_t tile, std::string label);

}  // namespace talus
