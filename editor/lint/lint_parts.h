// The parts of the lint. Each appends the problems that it finds.
#pragma once

#include <array>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// All that is wrong at the cells of an area, from its first to its last, both on the map; in no order.
void lint_cells(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area,
                std::vector<Problem>& out);
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
std::vector<Seam> seams_in(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area);

// Of the problems at cells, those of seams and cracks, and those of gaps that a player does not fit through.
void lint_seams(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area,
                std::vector<Problem>& out);
void lint_gaps(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area,
               std::vector<Problem>& out);

// All that is wrong elsewhere: with roles, shapes, curves and spawns. has_balls: there are ball tiles.
void lint_level(const Level& level, const LintTiles& tiles, bool has_balls, std::vector<Problem>& out);

// What is wrong with what is beside a flagged slope: the rule's code, and the end of a sentence. None where
// no flagged slope is.
struct SlopeFault {
  const char* code;
  std::string text;
};
std::optional<SlopeFault> slope_fault_at(const Level& level, const LintTiles& tiles, Cell cell);

// The cells on the map that lack a tile to draw the rest of the shape in a cell, from left to right: none
// where there is no shape, where flags make it a slope, or where its own tile is not drawn either.
std::vector<Cell> undrawn_cells(const Level& level, const LintTiles& tiles, Cell cell);

// How deep a body of this size with this corner, px, lies below the floor that the article computes for a
// slope flagged in the cell; 0 when it is above, or beside the slope's box.
double depth_in_slope(const Level& level, Vec2 corner, Vec2 size, Cell at);

bool is_before(const Problem& a, const Problem& b);  // by row, column and rule

}  // namespace talus
