// Cuts the shapes of tiles into their columns.
#include "tile_outlines.h"

#include <cmath>

#include "twofold.h"

namespace talus {
namespace {

int tiles_of(const TileShape& shape) { return shape.kind == TileShape::Kind::solid ? 1 : shape.tiles; }

// The number of rows beside its own that a shape reaches over: upwards for a floor, downwards for a ceiling.
int extra_rows(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::solid) return 0;
  const double most = *std::max_element(shape.heights.begin(), shape.heights.end());
  return std::max(0, static_cast<int>(std::ceil(weld(most) / tile.height)) - 1);
}

OutlineLine line_between(double x0, double y0, double x1, double y1) {
  const bool first_is_base = y0 <= y1;
  const auto slope = Twofold<double>(y1 - y0) / (x1 - x0);
  return {x0, y0, x1, y1, first_is_base ? x0 : x1, first_is_base ? y0 : y1, slope.high, slope.low};
}

TileColumn column_of(const TileShape& shape, int column, TileSize tile) {
  const bool floor = shape.side == TileShape::Side::floor;
  const double side = tile.height, base = floor ? side : 0;
  const double x0 = static_cast<double>(column) * tile.width, x1 = x0 + tile.width;
  std::vector<double> heights = shape.heights;
  if (shape.kind == TileShape::Kind::solid) heights = {side, side};
  const double width = tiles_of(shape) * tile.width, parts = static_cast<double>(heights.size() - 1);
  const auto x = [&](std::size_t i) { return weld(width * static_cast<double>(i) / parts); };
  const auto y = [&](std::size_t i) { return floor ? base - weld(heights[i]) : base + weld(heights[i]); };

  TileColumn out;
  std::vector<OutlineLine>& line = floor ? out.top : out.bottom;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    if (!(x(i) < x1 && x(i + 1) > x0)) continue;
    line.push_back(line_between(x(i), y(i), x(i + 1), y(i + 1)));
    if (x(i + 1) < x1) out.joints.push_back(x(i + 1));
  }
  (floor ? out.bottom : out.top).push_back(line_between(x0, base, x1, base));
  out.highest = out.lowest = base;
  for (const OutlineLine& l : line) {
    out.highest = std::min({out.highest, l.y0, l.y1});
    out.lowest = std::max({out.lowest, l.y0, l.y1});
  }
  return out;
}

TileOutline outline_of(const TileShape& shape, TileSize tile) {
  TileOutline out;
  if (shape.kind == TileShape::Kind::none) return out;
  out.full = is_full(shape);
  out.line = !out.full;
  out.one_way = shape.one_way;
  out.is_floor = shape.side == TileShape::Side::floor;
  if (out.line) out.touched = cells_touched_by(shape, {0, 0}, tile);
  for (int column = 0; column < tiles_of(shape); ++column)
    out.columns.push_back(column_of(shape, column, tile));
  return out;
}

}  // namespace

bool is_full(const TileShape& shape) { return shape.kind == TileShape::Kind::solid && !shape.one_way; }

bool is_line_shape(const TileShape& shape) { return shape.kind != TileShape::Kind::none && !is_full(shape); }

double height_of_line(const TileShape& shape, double x, TileSize tile) {
  if (shape.kind == TileShape::Kind::solid) return tile.height;
  const double step = shape.tiles * tile.width / static_cast<double>(shape.heights.size() - 1);
  const std::size_t i = std::min(shape.heights.size() - 2, static_cast<std::size_t>(x / step));
  const double along = x / step - static_cast<double>(i);
  return (1 - along) * shape.heights[i] + along * shape.heights[i + 1];
}

std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell, TileSize tile) {
  const int extra = extra_rows(shape, tile);
  const bool floor = shape.side == TileShape::Side::floor;
  return {Cell{cell.x - 1, cell.y - (floor ? extra : 0) - 1},
          Cell{cell.x + tiles_of(shape), cell.y + (floor ? 0 : extra) + 1}};
}

TileOutlines::TileOutlines(std::span<const TileShape> shapes, TileSize tile) : tile_(tile) {
  for (const TileShape& shape : shapes) {
    const TileOutline& outline = tiles_.emplace_back(outline_of(shape, tile));
    if (!outline.line) continue;
    has_lines_ = true;
    touched_[0].y = std::min(touched_[0].y, outline.touched[0].y);
    touched_[1].x = std::max(touched_[1].x, outline.touched[1].x);
    touched_[1].y = std::max(touched_[1].y, outline.touched[1].y);
  }
}

std::array<Cell, 2> TileOutlines::reach_of(Cell cell) const {
  return {Cell{cell.x + touched_[0].x, cell.y + touched_[0].y},
          Cell{cell.x + touched_[1].x, cell.y + touched_[1].y}};
}

std::array<Cell, 2> TileOutlines::sources_of(std::array<Cell, 2> area) const {
  return {Cell{area[0].x - touched_[1].x, area[0].y - touched_[1].y},
          Cell{area[1].x - touched_[0].x, area[1].y - touched_[0].y}};
}

}  // namespace talus
