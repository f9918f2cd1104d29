// The ground in a strip one cell wide is a set of bodies, each between a top and a bottom line. A line is
// outline where no other body covers it; a strip's side is, where the strip beside it is open.
#include "outline_compiler.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "twofold.h"

namespace talus {
namespace {

double left_of(int column) { return static_cast<double>(column) * kTileSide; }

int tiles_of(const TileShape& shape) { return shape.kind == TileShape::Kind::solid ? 1 : shape.tiles; }

// How many rows beside its own a shape reaches over: upwards (a floor) or downwards (a ceiling).
int extra_rows(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::solid) return 0;
  const double most = *std::max_element(shape.heights.begin(), shape.heights.end());
  return std::max(0, static_cast<int>(std::ceil(weld(most) / kTileSide)) - 1);
}

// Where `a` is below `b` between x0 and x1, both being straight there; with `or_equal`, also where they are
// equal throughout. Rounded inwards to 1/256 px: what is covered a little too much would be a hole.
struct Span {
  double from, to;
  bool empty() const { return !(from < to); }
};
Span where_less(double a0, double a1, double b0, double b1, double x0, double x1, bool or_equal) {
  const double d0 = b0 - a0, d1 = b1 - a1;
  if (d0 == 0 && d1 == 0) return or_equal ? Span{x0, x1} : Span{x0, x0};
  if (d0 >= 0 && d1 >= 0) return {x0, x1};
  if (d0 <= 0 && d1 <= 0) return {x0, x0};
  const double crossing = x0 + (x1 - x0) * (d0 / (d0 - d1));
  if (d0 > 0) return {x0, std::floor(crossing * 256) / 256};
  return {std::ceil(crossing * 256) / 256, x1};
}

template <class T>
std::vector<T> without(const std::vector<T>& parts, double from, double to) {
  std::vector<T> left;
  for (const T& part : parts) {
    if (to <= part.from || from >= part.to) {
      left.push_back(part);
      continue;
    }
    if (part.from < from) left.push_back({part.from, from});
    if (to < part.to) left.push_back({to, part.to});
  }
  return left;
}

}  // namespace

bool is_full(const TileShape& shape) { return shape.kind == TileShape::Kind::solid && !shape.one_way; }

bool is_line_shape(const TileShape& shape) { return shape.kind != TileShape::Kind::none && !is_full(shape); }

std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell) {
  const int extra = extra_rows(shape);
  const bool floor = shape.side == TileShape::Side::floor;
  return {Cell{cell.x - 1, cell.y - (floor ? extra : 0) - 1},
          Cell{cell.x + tiles_of(shape), cell.y + (floor ? 0 : extra) + 1}};
}

OutlineCompiler::OutlineCompiler(int width, std::span<const TileShape> shapes,
                                 std::span<const Piece<double>> curves, const CurveEnds& curve_ends,
                                 ShapeAt shape_at)
    : width_(width), curves_(curves), curve_ends_(curve_ends), shape_at_(std::move(shape_at)) {
  for (const TileShape& shape : shapes) {
    if (!is_line_shape(shape)) continue;
    most_tiles_ = std::max(most_tiles_, tiles_of(shape));
    int& most = shape.side == TileShape::Side::floor ? most_up_ : most_down_;
    most = std::max(most, extra_rows(shape));
  }
}

std::array<Cell, 2> OutlineCompiler::reach_of(Cell cell) const {
  return {Cell{cell.x - 1, cell.y - most_up_ - 1}, Cell{cell.x + most_tiles_, cell.y + most_down_ + 1}};
}

std::array<Cell, 2> OutlineCompiler::sources_of(std::array<Cell, 2> area) const {
  return {Cell{area[0].x - most_tiles_, area[0].y - most_down_ - 1},
          Cell{area[1].x + 1, area[1].y + most_up_ + 1}};
}

void OutlineCompiler::gather(Cell cell) {
  anchors_.clear();
  const std::array<Cell, 2> sources = sources_of({cell, cell});
  for (Cell at{0, sources[0].y}; at.y <= sources[1].y; ++at.y) {
    for (at.x = sources[0].x; at.x <= sources[1].x; ++at.x) {
      const TileShape& shape = shape_at_(at);
      if (!is_line_shape(shape)) continue;
      const std::array<Cell, 2> touched = cells_touched_by(shape, at);
      const bool touches = cell.x >= touched[0].x && cell.x <= touched[1].x && cell.y >= touched[0].y &&
                           cell.y <= touched[1].y;
      if (touches) anchors_.push_back({at, &shape});
    }
  }
}

// ---- Bodies ----

double OutlineCompiler::Line::at(double x) const {
  if (x <= x0) return y0;
  if (x >= x1) return y1;
  return std::clamp(base_y + (x - base_x) * slope, std::min(y0, y1), std::max(y0, y1));
}

OutlineCompiler::Line OutlineCompiler::line_between(double x0, double y0, double x1, double y1) {
  const bool first_is_base = y0 <= y1;
  const auto slope = Twofold<double>(y1 - y0) / (x1 - x0);
  return {x0, y0, x1, y1, first_is_base ? x0 : x1, first_is_base ? y0 : y1, slope.high, slope.low};
}

double OutlineCompiler::height_at(const std::vector<Line>& lines, double x, bool to_the_right) {
  for (const Line& line : lines) {
    if (to_the_right ? line.x0 <= x && x < line.x1 : line.x0 < x && x <= line.x1) return line.at(x);
  }
  return lines.empty() ? 0 : (x <= lines.front().x0 ? lines.front().y0 : lines.back().y1);
}

// The part of a shape in one strip.
OutlineCompiler::Body OutlineCompiler::body_of(const TileShape& shape, Cell anchor, int column) const {
  const bool floor = shape.side == TileShape::Side::floor;
  const double x0 = left_of(anchor.x), top = left_of(anchor.y), bottom = top + kTileSide;
  const double strip0 = left_of(column), strip1 = strip0 + kTileSide;
  Body body;
  body.origin = static_cast<std::int32_t>(anchor.y) * width_ + anchor.x;
  body.one_way = shape.one_way;
  body.is_floor = floor;
  body.has_top = !shape.one_way || floor;
  body.has_bottom = !shape.one_way || !floor;

  std::vector<double> heights = shape.heights;
  if (shape.kind == TileShape::Kind::solid) heights = {kTileSide, kTileSide};
  const double width = tiles_of(shape) * kTileSide;
  const double parts = static_cast<double>(heights.size() - 1);
  std::vector<Line>& line = floor ? body.top : body.bottom;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double a = weld(x0 + width * static_cast<double>(i) / parts);
    const double b = weld(x0 + width * static_cast<double>(i + 1) / parts);
    if (b <= strip0 || a >= strip1) continue;
    const auto y = [&](double height) { return floor ? bottom - weld(height) : top + weld(height); };
    line.push_back(line_between(a, y(heights[i]), b, y(heights[i + 1])));
  }
  const double base = floor ? bottom : top;
  (floor ? body.bottom : body.top) = {line_between(strip0, base, strip1, base)};
  return body;
}

OutlineCompiler::Strip OutlineCompiler::strip_of(int column, int row) const {
  Strip strip;
  for (int y = row - 1; y <= row + 1; ++y) {
    const TileShape& shape = shape_at_({column, y});
    if (is_full(shape)) strip.push_back(body_of(shape, {column, y}, column));
  }
  for (const Anchor& anchor : anchors_) {
    if (column < anchor.cell.x || column >= anchor.cell.x + tiles_of(*anchor.shape)) continue;
    strip.push_back(body_of(*anchor.shape, anchor.cell, column));
  }
  return strip;
}

void OutlineCompiler::compile(Cell cell, std::span<const std::uint32_t> curve_numbers,
                              std::vector<Piece<double>>& out) {
  gather(cell);
  before_ = strip_of(cell.x - 1, cell.y);
  here_ = strip_of(cell.x, cell.y);
  after_ = strip_of(cell.x + 1, cell.y);
  const std::size_t begin = out.size();
  for (std::size_t body = 0; body < here_.size(); ++body) {
    if (here_[body].has_top) compile_surface(body, true, cell, out);
    if (here_[body].has_bottom) compile_surface(body, false, cell, out);
  }
  compile_wall(cell, true, out);
  compile_wall(cell, false, out);
  compile_tips(cell, out);
  for (const std::uint32_t number : curve_numbers) out.push_back(curves_[number]);
  for (std::size_t i = begin; i < out.size(); ++i) mark_ends(out[i], cell);
}

// ---- Floors and ceilings ----

// The exposed parts of one line of a body, in this cell.
void OutlineCompiler::compile_surface(std::size_t number, bool top, Cell cell,
                                      std::vector<Piece<double>>& out) const {
  const Body& body = here_[number];
  const double strip0 = left_of(cell.x), strip1 = strip0 + kTileSide;
  const double row0 = left_of(cell.y), row1 = row0 + kTileSide;
  for (const Line& line : top ? body.top : body.bottom) {
    // Between the ends of all lines every line is straight, so that two cross once at most.
    std::vector<double> ends = {std::max(line.x0, strip0), std::min(line.x1, strip1)};
    for (const Body& other : here_) {
      for (const std::vector<Line>* lines : {&other.top, &other.bottom}) {
        for (const Line& l : *lines) {
          for (const double x : {l.x0, l.x1}) {
            if (x > ends[0] && x < ends[1]) ends.push_back(x);
          }
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    std::vector<Interval> open;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (ends[i] == ends[i + 1]) continue;
      std::vector<Interval> parts = {{ends[i], ends[i + 1]}};
      for (const Interval& h : hidden_parts(number, top, line, ends[i], ends[i + 1])) {
        parts = without(parts, h.from, h.to);
      }
      for (const Interval& part : parts) {
        if (!open.empty() && open.back().to == part.from) {
          open.back().to = part.to;
        } else {
          open.push_back(part);
        }
      }
    }
    for (const Interval& part : open) {
      const double y0 = line.at(part.from), y1 = line.at(part.to);
      const double low = std::min(y0, y1), high = std::max(y0, y1);
      const bool in_row = top ? low < row1 && (high > row0 || (low == high && low == row0))
                              : high > row0 && (low < row1 || (low == high && high == row1));
      if (!in_row) continue;
      Piece<double>& piece = out.emplace_back();
      piece = {.x0 = part.from,
               .y0 = y0,
               .x1 = part.to,
               .y1 = y1,
               .base_x = line.base_x,
               .base_y = line.base_y,
               .slope = line.slope,
               .slope_rest = line.slope_rest,
               .origin = body.origin,
               .stretch = 0,
               .facing = top ? Facing::up : Facing::down};
      piece.one_way = body.one_way;
    }
  }
}

// Where the line of a body is inside of others, or is the same as an earlier one's; or bounds nothing.
std::vector<OutlineCompiler::Interval> OutlineCompiler::hidden_parts(std::size_t number, bool top,
                                                                     const Line& line, double x0,
                                                                     double x1) const {
  std::vector<Interval> hidden;
  const double y0 = line.at(x0), y1 = line.at(x1);
  for (std::size_t j = 0; j < here_.size(); ++j) {
    const Body& other = here_[j];
    const double top0 = height_at(other.top, x0, true), top1 = height_at(other.top, x1, false);
    const double bottom0 = height_at(other.bottom, x0, true), bottom1 = height_at(other.bottom, x1, false);
    if (j == number) {
      if (!other.one_way && top0 == bottom0 && top1 == bottom1) hidden.push_back({x0, x1});
      continue;
    }
    if (other.one_way) continue;
    // Of two equal lines that face the same way, that of the later body goes.
    const bool later = j < number;
    const Span below_top = where_less(top0, top1, y0, y1, x0, x1, top ? later : true);
    const Span above_bottom = where_less(y0, y1, bottom0, bottom1, x0, x1, top ? true : later);
    const Span both = {std::max(below_top.from, above_bottom.from), std::min(below_top.to, above_bottom.to)};
    const bool is_body = top0 != bottom0 || top1 != bottom1;
    if (is_body && !both.empty()) hidden.push_back({both.from, both.to});
  }
  return hidden;
}

// ---- Walls ----

Piece<double> OutlineCompiler::wall_at(double x, double y0, double y1, bool left, std::int32_t origin,
                                       bool convex0, bool convex1) {
  Piece<double> wall = {.x0 = x,
                        .y0 = y0,
                        .x1 = x,
                        .y1 = y1,
                        .base_x = x,
                        .base_y = y0,
                        .slope = 0,
                        .origin = origin,
                        .stretch = 0,
                        .facing = left ? Facing::left : Facing::right};
  wall.convex0 = convex0;
  wall.convex1 = convex1;
  return wall;
}

// The side of the strip in this cell where the ground is on the one hand and not on the other.
void OutlineCompiler::compile_wall(Cell cell, bool left, std::vector<Piece<double>>& out) const {
  const double x = left_of(cell.x) + (left ? 0 : kTileSide);
  const double row0 = left_of(cell.y), row1 = row0 + kTileSide;
  const auto covered = [x](const Strip& strip, bool to_the_right) {
    std::vector<std::pair<Interval, std::int32_t>> parts;
    for (const Body& body : strip) {
      if (body.one_way) continue;
      parts.push_back(
          {{height_at(body.top, x, to_the_right), height_at(body.bottom, x, to_the_right)}, body.origin});
    }
    std::sort(parts.begin(), parts.end(),
              [](const auto& a, const auto& b) { return a.first.from < b.first.from; });
    std::vector<std::pair<Interval, std::int32_t>> merged;
    for (const auto& part : parts) {
      if (!merged.empty() && part.first.from <= merged.back().first.to) {
        merged.back().first.to = std::max(merged.back().first.to, part.first.to);
      } else {
        merged.push_back(part);
      }
    }
    return merged;
  };
  const auto ours = covered(here_, left), theirs = covered(left ? before_ : after_, !left);

  for (const auto& [whole, origin] : ours) {
    std::vector<Interval> parts = {whole};
    for (const auto& t : theirs) parts = without(parts, t.first.from, t.first.to);
    for (const Interval& part : parts) {
      const double y0 = std::max(part.from, row0), y1 = std::min(part.to, row1);
      if (y0 < y1) out.push_back(wall_at(x, y0, y1, left, origin, y0 == whole.from, y1 == whole.to));
    }
  }
}

// Whether a body has more than a line right (or left) beside x.
bool OutlineCompiler::is_thick(const Body& body, double x, bool to_the_right) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double far = to_the_right ? infinity : -infinity;
  for (const std::vector<Line>* lines : {&body.top, &body.bottom}) {
    for (const Line& line : *lines) {
      if (to_the_right && line.x0 <= x && x < line.x1) far = std::min(far, line.x1);
      if (!to_the_right && line.x0 < x && x <= line.x1) far = std::max(far, line.x0);
    }
  }
  if (std::isinf(far)) return false;
  return height_at(body.top, x, to_the_right) != height_at(body.bottom, x, to_the_right) ||
         height_at(body.top, far, !to_the_right) != height_at(body.bottom, far, !to_the_right);
}

// The tips of wedges: where a body's top and bottom meet and nothing goes on.
void OutlineCompiler::compile_tips(Cell cell, std::vector<Piece<double>>& out) const {
  const double strip0 = left_of(cell.x), strip1 = strip0 + kTileSide;
  const double row0 = left_of(cell.y), row1 = row0 + kTileSide;
  const auto goes_on_at = [&](double x, double y, bool to_the_right) {
    const Strip& strip = x == strip0 && !to_the_right  ? before_
                         : x == strip1 && to_the_right ? after_
                                                       : here_;
    return std::any_of(strip.begin(), strip.end(), [&](const Body& body) {
      return !body.one_way && is_thick(body, x, to_the_right) && height_at(body.top, x, to_the_right) <= y &&
             y <= height_at(body.bottom, x, to_the_right);
    });
  };
  for (const Body& body : here_) {
    if (body.one_way) continue;
    for (const Line& line : body.is_floor ? body.top : body.bottom) {
      for (const bool first : {true, false}) {
        const double x = first ? line.x0 : line.x1, y = first ? line.y0 : line.y1;
        const bool here = x >= strip0 && x <= strip1 && y >= row0 && y <= row1;
        if (!here || y != height_at(body.top, x, first) || y != height_at(body.bottom, x, first)) continue;
        if (line.y0 == line.y1 || goes_on_at(x, y, !first)) continue;
        out.push_back(wall_at(x, y, y, first, body.origin, true, true));
      }
    }
  }
}

// ---- Ends ----

void OutlineCompiler::mark_ends(Piece<double>& piece, Cell cell) const {
  if (piece.is_wall()) return;
  // A long piece is marked at its ends in the cells that the ends are in, where their surroundings are known.
  const auto is_near = [cell](double x, double y) {
    return x >= left_of(cell.x) && x <= left_of(cell.x + 1) && y >= left_of(cell.y) &&
           y <= left_of(cell.y + 1);
  };
  const bool near0 = piece.origin >= 0 || is_near(piece.x0, piece.y0);
  const bool near1 = piece.origin >= 0 || is_near(piece.x1, piece.y1);
  piece.far0 = !near0;
  piece.far1 = !near1;
  piece.convex0 = near0 && !goes_on(piece, true, true);
  piece.convex1 = near1 && !goes_on(piece, false, true);
  piece.last0 = near0 && !goes_on(piece, true, false);
  piece.last1 = near1 && !goes_on(piece, false, false);
}

// Whether another line that faces the same way begins where this one ends; with `only_outward`, one that
// does not fall back from the open side.
bool OutlineCompiler::goes_on(const Piece<double>& piece, bool first, bool only_outward) const {
  const double x = first ? piece.x0 : piece.x1, y = first ? piece.y0 : piece.y1;
  const bool up = piece.facing == Facing::up;
  // How much the line that goes on moves away from the ground, seen from this end.
  const auto outward = [&](double dy) { return up ? dy <= 0 : dy >= 0; };
  for (const Strip* strip : {&before_, &here_, &after_}) {
    for (const Body& body : *strip) {
      if (up ? !body.has_top : !body.has_bottom) continue;
      if (!body.one_way && !is_thick(body, x, !first)) continue;
      for (const Line& line : up ? body.top : body.bottom) {
        const bool reaches_on = first ? line.x0 < x && x <= line.x1 : line.x0 <= x && x < line.x1;
        if (!reaches_on || line.at(x) != y) continue;
        const double dy = first ? line.y0 - line.at(x) : line.y1 - line.at(x);
        if (!only_outward || outward(dy)) return true;
      }
    }
  }
  for (const CurveEnds::End& end : curve_ends_.at({x, y}, !first)) {
    const Piece<double>& curve = curves_[end.piece];
    if (curve.facing != piece.facing) continue;
    const double dy = first ? curve.y0 - curve.y1 : curve.y1 - curve.y0;
    if (!only_outward || outward(dy)) return true;
  }
  return false;
}

}  // namespace talus
