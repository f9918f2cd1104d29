// Where the outline of the ground jumps between two columns of cells, and where it stays open inside the
// ground.
#pragma once

#include <array>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// Where a floor or a ceiling ends at the border of two columns of cells, and the next one is higher or lower.
struct Seam {
  Cell left, right;                // in which the two end
  double left_y = 0, right_y = 0;  // px
  Cell left_tile, right_tile;      // whose shapes they are
  bool floor = true;
};
// Where a floor in a cell has a ceiling so close above it that no body gets between them.
struct Crack {
  Cell cell;
  double gap = 0;  // px, at its end
};

struct SeamsAndCracks {
  std::vector<Seam> seams;
  std::vector<Crack> cracks;
};
// Those at the cells of an area, from its first to its last, both on the map.
SeamsAndCracks find_seams(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area);

}  // namespace talus
