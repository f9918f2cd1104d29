// Cuts the shapes of tiles into their columns.
#include "tile_outlines.h"

#include <cmath>

#include "polygon_columns.h"
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
    line.push_back(line_between({x(i), y(i)}, {x(i + 1), y(i + 1)}));
    if (x(i + 1) < x1) out.joints.push_back(x(i + 1));
  }
  (floor ? out.bottom : out.top).push_back(line_between({x0, base}, {x1, base}));
  out.left = x0, out.right = x1;
  out.one_way = shape.one_way;
  out.is_floor = floor;
  out.highest = out.lowest = base;
  for (const OutlineLine& l : line) {
    out.highest = std::min({out.highest, l.y0, l.y1});
    out.lowest = std::max({out.lowest, l.y0, l.y1});
  }
  return out;
}

std::array<Cell, 2> cells_touched_by_polygon(const TileShape& polygon, Cell cell, TileSize tile) {
  const auto [left, right] = columns_of(polygon, tile);
  const auto [high, low] = std::minmax_element(polygon.points.begin(), polygon.points.end(),
                                               [](Vec2 a, Vec2 b) { return a.y < b.y; });
  const int top = static_cast<int>(std::floor(weld(high->y) / tile.height));
  const int bottom = static_cast<int>(std::ceil(weld(low->y) / tile.height)) - 1;
  return {Cell{cell.x + left - 1, cell.y + top - 1}, Cell{cell.x + right + 1, cell.y + bottom + 1}};
}

// A group of one part is that part.
const TileShape& only_part(const TileShape& shape) {
  return shape.kind == TileShape::Kind::group && shape.parts.size() == 1 ? shape.parts.front() : shape;
}

std::span<const TileShape> parts_of(const TileShape& shape) {
  return shape.kind == TileShape::Kind::group ? std::span<const TileShape>(shape.parts)
                                              : std::span<const TileShape>(&shape, 1);
}

// The parts of a polygon or a group, sorted into their columns.
void cut(const TileShape& shape, TileSize tile, TileOutline& out) {
  struct Part {
    int column;
    TileColumn part;
  };
  std::vector<Part> all;
  int number = 0;
  for (const TileShape& part : parts_of(shape)) {
    std::vector<TileColumn> columns;
    if (part.kind == TileShape::Kind::polygon) {
      cut_polygon(part, number++, tile, columns);
    } else {
      for (int column = 0; column < tiles_of(part); ++column)
        columns.push_back(column_of(part, column, tile));
    }
    for (TileColumn& column : columns)
      all.push_back({static_cast<int>(std::floor(column.left / tile.width)), std::move(column)});
  }
  std::stable_sort(all.begin(), all.end(), [](const Part& a, const Part& b) { return a.column < b.column; });
  out.first_column = all.front().column;
  for (Part& part : all) {
    while (out.first_column + static_cast<int>(out.first.size()) <= part.column)
      out.first.push_back(static_cast<std::uint32_t>(out.columns.size()));
    out.columns.push_back(std::move(part.part));
  }
  out.first.push_back(static_cast<std::uint32_t>(out.columns.size()));
}

TileOutline outline_of(const TileShape& given, TileSize tile) {
  TileOutline out;
  const TileShape& shape = only_part(given);
  if (shape.kind == TileShape::Kind::none) return out;
  out.full = is_full(shape);
  out.line = !out.full;
  if (out.line) out.touched = cells_touched_by(shape, {0, 0}, tile);
  if (has_parts(shape)) {
    cut(shape, tile, out);
    return out;
  }
  for (int column = 0; column < tiles_of(shape); ++column)
    out.columns.push_back(column_of(shape, column, tile));
  return out;
}

}  // namespace

double OutlineLine::precise_at(double x) const {
  return (Twofold<double>(x - base_x) * Twofold<double>(slope, slope_rest) + base_y).rounded();
}

OutlineLine line_between(Vec2 from, Vec2 to) {
  const bool first_is_base = from.y <= to.y;
  const auto slope = Twofold<double>(to.y - from.y) / (to.x - from.x);
  const Vec2 base = first_is_base ? from : to;
  return {from.x, from.y, to.x, to.y, base.x, base.y, slope.high, slope.low};
}

bool is_full(const TileShape& shape) {
  const TileShape& only = only_part(shape);
  return only.kind == TileShape::Kind::solid && !only.one_way;
}

bool is_line_shape(const TileShape& shape) { return shape.kind != TileShape::Kind::none && !is_full(shape); }

double height_of_line(const TileShape& shape, double x, TileSize tile) {
  if (shape.kind == TileShape::Kind::solid) return tile.height;
  const double step = shape.tiles * tile.width / static_cast<double>(shape.heights.size() - 1);
  const std::size_t i = std::min(shape.heights.size() - 2, static_cast<std::size_t>(x / step));
  const double along = x / step - static_cast<double>(i);
  return (1 - along) * shape.heights[i] + along * shape.heights[i + 1];
}

std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell, TileSize tile) {
  if (shape.kind == TileShape::Kind::group) {
    std::array<Cell, 2> all = cells_touched_by(shape.parts.front(), cell, tile);
    for (const TileShape& part : shape.parts) {
      const std::array<Cell, 2> some = cells_touched_by(part, cell, tile);
      all[0] = {std::min(all[0].x, some[0].x), std::min(all[0].y, some[0].y)};
      all[1] = {std::max(all[1].x, some[1].x), std::max(all[1].y, some[1].y)};
    }
    return all;
  }
  if (shape.kind == TileShape::Kind::polygon) return cells_touched_by_polygon(shape, cell, tile);
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
    const auto& [first, last] = outline.touched;
    touched_[0] = {std::min(touched_[0].x, first.x), std::min(touched_[0].y, first.y)};
    touched_[1] = {std::max(touched_[1].x, last.x), std::max(touched_[1].y, last.y)};
  }
  if (std::any_of(shapes.begin(), shapes.end(), has_parts)) make_precise();
}

// Sides of polygons may lie on any other line.
void TileOutlines::make_precise() {
  for (TileOutline& tile : tiles_) {
    for (TileColumn& column : tile.columns) {
      for (OutlineLine& line : column.top) line.precise = true;
      for (OutlineLine& line : column.bottom) line.precise = true;
    }
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
