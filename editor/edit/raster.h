// Lines, ellipses and connected areas on a grid, for the tools of the map and of the sprite canvas alike.
#pragma once

#include <vector>

#include <talus/collision/function_ref.h>
#include <talus/collision/geometry.h>

namespace talus {

// Visits every cell of the straight line between two cells, both included, from the first to the last.
void for_each_on_line(Cell from, Cell to, FunctionRef<void(Cell)> visit);

// The cells of one row from column `first` to column `last`, both included.
struct Span {
  int y, first, last;
  friend bool operator==(const Span&, const Span&) = default;
};

// The 4-connected area around `at` where `inside` holds, in a grid of width x height cells; each cell is in
// one span. Empty if `at` is outside of the grid. Takes time and memory by the area, without recursion.
std::vector<Span> flood_area(int width, int height, Cell at, FunctionRef<bool(Cell)> inside);

// The cells of a rectangle whose centres lie in the ellipse that touches its sides: one span for each row,
// from the top, in columns and rows of the rectangle. width, height: >= 1. A row has at least one cell, so
// that a thin ellipse has no gaps.
std::vector<Span> ellipse_spans(int width, int height);

}  // namespace talus
