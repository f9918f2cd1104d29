// Finds where the outline of the ground jumps between two columns of cells, and where it stays open inside
// the ground.
#pragma once

#include <array>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// A floor or a ceiling that ends at the border of two columns of cells, where the next one is higher or
// lower.
struct Seam {
  Cell left, right;                // the cells in which the two end
  double left_y = 0, right_y = 0;  // px
  Cell left_tile, right_tile;      // the cells of the tiles whose shapes they are
  bool floor = true;
};
// A floor in a cell with a ceiling so close above it that no body fits between them.
struct Crack {
  Cell cell;
  double gap = 0;  // height at its end, px
};

struct SeamsAndCracks {
  std::vector<Seam> seams;
  std::vector<Crack> cracks;
};
// Returns the seams and cracks in an area, from its first to its last cell, both on the map.
SeamsAndCracks find_seams(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area);

}  // namespace talus
