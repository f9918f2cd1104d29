// TileOutline: what each kind of tile adds to the outline of the ground, computed once for all its cells.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// Whether it is a full tile, all of whose sides are ground.
bool is_full(const TileShape& shape);
// Whether it is a shape, but not a full tile: its outline is in pieces.
bool is_line_shape(const TileShape& shape);
// Height of the line of a slope or profile, or of a full tile, px, at a distance from its left side, px. The
// distance of a good shape goes up to its width.
double height_of_line(const TileShape& shape, double x, TileSize tile);
// The first and the last of the cells whose outline such a shape may change.
std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell, TileSize tile);

// The line of a slope or profile between two of its heights, a side of a polygon, or a flat side of a tile.
struct OutlineLine {
  double x0, y0, x1, y1;                     // px, x0 < x1
  double base_x, base_y, slope, slope_rest;  // as those of a Piece
  // Whether heights are rounded only once. Then lines on one straight line have the same heights, whatever
  // their ends are.
  bool precise = false;
  double at(double x) const {
    if (x <= x0) return y0;
    if (x >= x1) return y1;
    const double y = precise ? precise_at(x) : base_y + (x - base_x) * slope;
    return std::clamp(y, std::min(y0, y1), std::max(y0, y1));
  }
  double precise_at(double x) const;
  // The same as moved(by).at(x), for an x that is welded.
  double moved_at(Vec2 by, double x) const {
    const double here = x - by.x;
    if (here <= x0) return y0 + by.y;
    if (here >= x1) return y1 + by.y;
    if (precise) return moved(by).at(x);
    const double y = (base_y + by.y) + (here - base_x) * slope;
    return std::clamp(y, std::min(y0, y1) + by.y, std::max(y0, y1) + by.y);
  }
  // The height is exact, as ends are welded.
  OutlineLine moved(Vec2 by) const {
    return {x0 + by.x,     y0 + by.y, x1 + by.x,  y1 + by.y, base_x + by.x,
            base_y + by.y, slope,     slope_rest, precise};
  }
};
OutlineLine line_between(Vec2 from, Vec2 to);  // from.x < to.x

// The part of a shape in one column of cells; lines from left to right. The lines of a slope continue in the
// next column. Of a polygon, it is the part between two of its sides; others may lie beside, above and below
// it in the same column, and the lines are the whole sides.
struct TileColumn {
  std::vector<OutlineLine> top, bottom;
  std::vector<double> joints;      // x, inside of the column, where two lines meet
  double highest = 0, lowest = 0;  // the range of their y
  double left = 0, right = 0;      // x of its ends: those of the column, or closer
  bool one_way = false;
  bool is_floor = true;  // of a one-way shape, slope or profile: whether its line is the top, not the bottom
  int polygon = -1;      // which polygon of the shape it is of; -1: none
};

struct TileOutline {
  bool full = false;                 // see is_full
  bool line = false;                 // see is_line_shape
  std::array<Cell, 2> touched{};     // see cells_touched_by; relative to its own cell
  int first_column = 0;              // the column of the first part, counted from its own cell
  std::vector<TileColumn> columns;   // px, relative to the corner of its own cell; from column to column
  std::vector<std::uint32_t> first;  // by column, its first part, and the end; empty: each column has one

  // The number of columns from the first to the last.
  int width() const { return static_cast<int>(first.empty() ? columns.size() : first.size() - 1); }
  // The parts in a column, counted from its own cell.
  std::span<const TileColumn> in_column(int column) const {
    const int n = column - first_column;
    if (n < 0 || n >= width()) return {};
    const auto at = static_cast<std::size_t>(n);
    if (first.empty()) return {&columns[at], 1};
    return {columns.data() + first[at], columns.data() + first[at + 1]};
  }
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
  void make_precise();

  TileSize tile_;
  std::vector<TileOutline> tiles_;
  bool has_lines_ = false;
  // the union of `touched` of all lines; at least the cells beside a full tile
  std::array<Cell, 2> touched_ = {Cell{-1, -1}, Cell{1, 1}};
};

}  // namespace talus
