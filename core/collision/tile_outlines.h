// TileOutline: what each kind of tile adds to the outline of the ground, computed once for all its cells.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// Whether it is a full tile, all of whose sides are ground.
bool is_full(const TileShape& shape);
// Whether it is a shape, but not a full tile: its outline is in pieces.
bool is_line_shape(const TileShape& shape);
// Height of its line, px, at a distance from its left side, px. The distance of a good shape goes up to its
// width.
double height_of_line(const TileShape& shape, double x, TileSize tile);
// The first and the last of the cells whose outline such a shape may change.
std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell, TileSize tile);

// The line of a slope or profile between two of its heights, or a flat side of a tile.
struct OutlineLine {
  double x0, y0, x1, y1;                     // px, x0 < x1
  double base_x, base_y, slope, slope_rest;  // as those of a Piece
  double at(double x) const {
    if (x <= x0) return y0;
    if (x >= x1) return y1;
    return std::clamp(base_y + (x - base_x) * slope, std::min(y0, y1), std::max(y0, y1));
  }
  // The height is exact, as ends are welded.
  OutlineLine moved(Vec2 by) const {
    return {x0 + by.x, y0 + by.y, x1 + by.x, y1 + by.y, base_x + by.x, base_y + by.y, slope, slope_rest};
  }
};

// The part of a shape in one column of cells; lines from left to right. The lines of a slope continue in the
// next column.
struct TileColumn {
  std::vector<OutlineLine> top, bottom;
  std::vector<double> joints;      // x, inside of the column, where two lines meet
  double highest = 0, lowest = 0;  // the range of their y
};

struct TileOutline {
  bool full = false;  // see is_full
  bool line = false;  // see is_line_shape
  bool one_way = false;
  bool is_floor = true;             // of a line: whether its line is the top, not the bottom
  std::array<Cell, 2> touched{};    // see cells_touched_by; relative to its own cell
  std::vector<TileColumn> columns;  // px, relative to the corner of its own cell
};

class TileOutlines {
 public:
  // shapes: by tile number; they must be usable for tiles of that size (see problem_of).
  TileOutlines(std::span<const TileShape> shapes, TileSize tile);

  TileSize tile_size() const { return tile_; }
  double x_of(int column) const { return static_cast<double>(column) * tile_.width; }  // px, of its left side
  double y_of(int row) const { return static_cast<double>(row) * tile_.height; }       // px, of its top
  const TileOutline& operator[](std::size_t tile) const { return tiles_[tile]; }
  bool has_lines() const { return has_lines_; }
  // The cells whose outline depends on the given cell, from the first to the last.
  std::array<Cell, 2> reach_of(Cell cell) const;
  // The cells that the outline of the area's cells depends on.
  std::array<Cell, 2> sources_of(std::array<Cell, 2> area) const;

 private:
  TileSize tile_;
  std::vector<TileOutline> tiles_;
  bool has_lines_ = false;
  // the union of `touched` of all lines; at least the cells beside a full tile
  std::array<Cell, 2> touched_ = {Cell{-1, -1}, Cell{1, 1}};
};

}  // namespace talus
