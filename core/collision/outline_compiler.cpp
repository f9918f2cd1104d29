// The ground in a strip one cell wide is a set of bodies, each between a top and a bottom line. A line is
// outline where no other body covers it. The side of a strip is outline where the strip beside it is open.
// Bodies of polygons may begin and end between the sides of a strip. There, too, a side of the ground is
// outline where no ground is beside it.
#include "outline_compiler.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

// Where `a` is below `b` between x0 and x1; both are straight there. or_equal: counts places where they are
// equal, too, if they are equal throughout. The result is rounded inwards to 1/256 px: covering a little too
// much would leave a hole.
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
  if (d0 > 0) return {x0, std::floor(crossing * kWeldParts) / kWeldParts};
  return {std::ceil(crossing * kWeldParts) / kWeldParts, x1};
}

}  // namespace

OutlineCompiler::OutlineCompiler(int width, const TileOutlines& tiles, std::span<const Piece<double>> curves,
                                 const CurveEnds& curve_ends, TilesAt tiles_at)
    : width_(width),
      tiles_(tiles),
      curves_(curves),
      curve_ends_(curve_ends),
      tiles_at_(std::move(tiles_at)) {}

void OutlineCompiler::enter(std::array<Cell, 2> area) {
  sources_ = tiles_.sources_of(area);
  sources_width_ = sources_[1].x - sources_[0].x + 1;
  const auto width = static_cast<std::size_t>(sources_width_);
  tiles_here_.resize(width * static_cast<std::size_t>(sources_[1].y - sources_[0].y + 1));
  for (int y = sources_[0].y; y <= sources_[1].y; ++y) {
    const std::span<const TileOutline*> all = tiles_here_;
    tiles_at_({sources_[0].x, y}, all.subspan(static_cast<std::size_t>(y - sources_[0].y) * width, width));
  }
  note_lines(area);
}

// Sorts the parts of all sloped tiles into their columns.
void OutlineCompiler::note_lines(std::array<Cell, 2> area) {
  lines_.clear();
  first_column_ = area[0].x - 1;
  parts_of_columns_.resize(static_cast<std::size_t>(area[1].x + 1 - first_column_ + 1));
  for (std::vector<Part>& parts : parts_of_columns_) parts.clear();
  const TileOutline* const* next = tiles_here_.data();
  for (Cell c = sources_[0]; c.y <= sources_[1].y; ++c.y) {
    for (c.x = sources_[0].x; c.x <= sources_[1].x; ++c.x) {
      const TileOutline& shape = **next++;
      if (!shape.line) continue;
      lines_.emplace_back(c, &shape);
      // What reaches over the map's left or right side is no ground.
      const int first = std::max({c.x + shape.first_column, first_column_, 0});
      const int last = std::min({c.x + shape.first_column + shape.width() - 1, area[1].x + 1, width_ - 1});
      for (int column = first; column <= last; ++column) {
        std::vector<Part>& parts = parts_of_columns_[static_cast<std::size_t>(column - first_column_)];
        for (const TileColumn& part : shape.in_column(column - c.x))
          parts.push_back({&part, c, c.y + shape.touched[0].y, c.y + shape.touched[1].y});
      }
    }
  }
}

void OutlineCompiler::compile(Cell cell, std::span<const std::uint32_t> curve_numbers,
                              std::vector<Piece<double>>& out) {
  before_ = &strip_at(cell.x - 1, cell.y);
  here_ = &strip_at(cell.x, cell.y);
  after_ = &strip_at(cell.x + 1, cell.y);
  const std::size_t begin = out.size();
  for (const Body& body : here_->bodies) {
    if (body.has(true)) compile_surface(body, true, cell, out);
    if (body.has(false)) compile_surface(body, false, cell, out);
  }
  compile_walls(cell, out);
  compile_tips(cell, out);
  for (const std::uint32_t number : curve_numbers) out.push_back(curves_[number]);
  for (std::size_t i = begin; i < out.size(); ++i) mark_ends(out[i], cell);
}

// ---- Bodies ----

OutlineCompiler::Body::Body(const TileOutlines& tiles, const TileColumn& of, Cell cell, bool full,
                            int map_width)
    : column(&of),
      corner{tiles.x_of(cell.x), tiles.y_of(cell.y)},
      origin(static_cast<std::int32_t>(cell.y) * map_width + cell.x),
      is_full(full),
      left(corner.x + column->left),
      right(corner.x + column->right),
      highest(corner.y + column->highest - 1.0 / kWeldParts),
      lowest(corner.y + column->lowest + 1.0 / kWeldParts),
      at_left(full ? Interval{corner.y + column->highest, corner.y + column->lowest}
                   : Interval{height_at(true, left, true), height_at(false, left, true)}),
      at_right(full ? at_left : Interval{height_at(true, right, false), height_at(false, right, false)}) {}

double OutlineCompiler::Body::height_at(bool top, double x, bool to_the_right) const {
  const double in_tile = x - corner.x;  // exact for ends of lines, which are welded
  const std::vector<OutlineLine>& all = lines(top);
  for (const OutlineLine& l : all) {
    const bool is_beside =
        to_the_right ? l.x0 <= in_tile && in_tile < l.x1 : l.x0 < in_tile && in_tile <= l.x1;
    if (is_beside) return l.moved_at(corner, x);
  }
  return corner.y + (in_tile <= all.front().x0 ? all.front().y0 : all.back().y1);
}

OutlineCompiler::Interval OutlineCompiler::Body::range_at(double x, bool to_the_right) const {
  if (is_full || (to_the_right ? x == left : x == right)) return to_the_right ? at_left : at_right;
  return {height_at(true, x, to_the_right), height_at(false, x, to_the_right)};
}

bool OutlineCompiler::Body::is_thick(double x, bool to_the_right) const {
  const double in_tile = x - corner.x;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double far = to_the_right ? infinity : -infinity;
  for (const bool top : {true, false}) {
    for (const OutlineLine& line : lines(top)) {
      if (to_the_right && line.x0 <= in_tile && in_tile < line.x1) far = std::min(far, line.x1);
      if (!to_the_right && line.x0 < in_tile && in_tile <= line.x1) far = std::max(far, line.x0);
    }
  }
  if (std::isinf(far)) return false;
  far = to_the_right ? std::min(far, column->right) : std::max(far, column->left);
  const Interval here = range_at(x, to_the_right), there = range_at(corner.x + far, !to_the_right);
  return here.from != here.to || there.from != there.to;
}

// The full tiles of the column beside a cell, and all else that may change the outline there.
const OutlineCompiler::Strip& OutlineCompiler::strip_at(int column, int row) {
  Strip& strip = strips_[static_cast<std::size_t>(column + 1) % strips_.size()];
  if (strip.cell == Cell{column, row}) return strip;
  strip.cell = {column, row};
  strip.bodies.clear();
  strip.has_polygons = false;
  for (int y = row - 1; y <= row + 1; ++y) {
    const TileOutline& full = tile({column, y});
    if (full.full) strip.bodies.emplace_back(tiles_, full.columns.front(), Cell{column, y}, true, width_);
  }
  const std::array<Cell, 2> sources = tiles_.sources_of({Cell{column, row}, Cell{column, row}});
  const std::vector<Part>& parts = parts_of_columns_[static_cast<std::size_t>(column - first_column_)];
  auto part = std::lower_bound(parts.begin(), parts.end(), sources[0].y,
                               [](const Part& p, int y) { return p.cell.y < y; });
  for (; part != parts.end() && part->cell.y <= sources[1].y; ++part) {
    if (row < part->first_row || row > part->last_row) continue;
    strip.bodies.emplace_back(tiles_, *part->column, part->cell, false, width_);
    strip.has_polygons = strip.has_polygons || part->column->polygon >= 0;
  }
  const double left = tiles_.x_of(column), right = tiles_.x_of(column + 1);
  cut(strip, left, right);
  cover(strip, left, true, strip.left);
  cover(strip, right, false, strip.right);
  return strip;
}

void OutlineCompiler::cut(Strip& strip, double left, double right) {
  strip.cuts.clear();
  if (!strip.has_polygons) return;
  for (const Body& body : strip.bodies) {
    if (body.left > left) strip.cuts.push_back(body.left);
    if (body.right < right) strip.cuts.push_back(body.right);
  }
  std::sort(strip.cuts.begin(), strip.cuts.end());
  strip.cuts.erase(std::unique(strip.cuts.begin(), strip.cuts.end()), strip.cuts.end());
}

// The strip right (or left) of an x of the current strip.
const OutlineCompiler::Strip& OutlineCompiler::strip_beside(double x, bool to_the_right) const {
  if (to_the_right) return x == tiles_.x_of(here_->cell.x + 1) ? *after_ : *here_;
  return x == tiles_.x_of(here_->cell.x) ? *before_ : *here_;
}

// The parts of a vertical line through a strip that have ground just right (or left) of it.
void OutlineCompiler::cover(const Strip& strip, double x, bool to_the_right, std::vector<Cover>& covers) {
  covers.clear();
  for (const Body& body : strip.bodies) {
    if (body.one_way() || (strip.has_polygons && !body.is_beside(x, to_the_right))) continue;
    const Cover here{body.range_at(x, to_the_right), body.origin};
    if (strip.has_polygons && body.is_of_polygon() && here.part.from == here.part.to) continue;  // a tip
    auto at = covers.end();  // usually the right place: few bodies are not listed from the top
    while (at != covers.begin() && here.part.from < (at - 1)->part.from) --at;
    covers.insert(at, here);
  }
  std::size_t last = 0;
  for (std::size_t i = 1; i < covers.size(); ++i) {
    if (covers[i].part.from <= covers[last].part.to) {
      covers[last].part.to = std::max(covers[last].part.to, covers[i].part.to);
    } else {
      covers[++last] = covers[i];
    }
  }
  if (!covers.empty()) covers.resize(last + 1);
}

// ---- Floors and ceilings ----

// Whether parts of a line between these heights may be outline of the row.
bool OutlineCompiler::may_be_in_row(double y0, double y1, bool top, double row0) const {
  const double row1 = row0 + tiles_.tile_size().height;
  return top ? std::min(y0, y1) < row1 && std::max(y0, y1) >= row0
             : std::max(y0, y1) > row0 && std::min(y0, y1) <= row1;
}

// The exposed parts of one side of a body, in this cell.
void OutlineCompiler::compile_surface(const Body& body, bool top, Cell cell,
                                      std::vector<Piece<double>>& out) {
  const double strip0 = tiles_.x_of(cell.x), strip1 = tiles_.x_of(cell.x + 1);
  const double row0 = tiles_.y_of(cell.y), row1 = tiles_.y_of(cell.y + 1);
  for (const OutlineLine& in_tile : body.lines(top)) {
    if (!may_be_in_row(body.corner.y + in_tile.y0, body.corner.y + in_tile.y1, top, row0)) continue;
    const OutlineLine line = in_tile.moved(body.corner);
    const Interval whole{std::max(line.x0, strip0), std::min(line.x1, strip1)};
    if (whole.from < body.left) continue;  // a side of a polygon counts once, with its first part
    if (!may_be_in_row(line.at(whole.from), line.at(whole.to), top, row0)) continue;
    find_open(body, top, line, whole);
    for (const Interval& part : open_) {
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
      piece.one_way = body.one_way();
    }
  }
}

// Puts the exposed parts of a line into open_.
void OutlineCompiler::find_open(const Body& body, bool top, const OutlineLine& line, const Interval& part) {
  // Between the ends of all lines every line is straight, so two of them cross at most once.
  ends_.clear();
  ends_.push_back(part.from);
  const auto add = [&](double x) {
    if (x > part.from && x < part.to) ends_.push_back(x);
  };
  for (const Body& other : here_->bodies) {
    for (const double joint : other.column->joints) add(other.corner.x + joint);
    if (!here_->has_polygons || !other.is_of_polygon() || other.is_of_polygon_of(body)) continue;
    add(other.left);
    add(other.right);
  }
  ends_.push_back(part.to);
  if (ends_.size() > 2) std::sort(ends_.begin(), ends_.end());
  open_.clear();
  for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
    if (ends_[i] == ends_[i + 1]) continue;
    parts_.clear();
    parts_.push_back({ends_[i], ends_[i + 1]});
    take_out_hidden(body, top, line, ends_[i], ends_[i + 1]);
    for (const Interval& exposed : parts_) {
      if (!open_.empty() && open_.back().to == exposed.from) {
        open_.back().to = exposed.to;
      } else {
        open_.push_back(exposed);
      }
    }
  }
}

// Removes from parts_ what does not bound the ground: where the line of a body is inside another body, and
// where it equals the line of an earlier one.
void OutlineCompiler::take_out_hidden(const Body& body, bool top, const OutlineLine& line, double x0,
                                      double x1) {
  const double y0 = line.at(x0), y1 = line.at(x1);
  const double highest = std::min(y0, y1), lowest = std::max(y0, y1);
  for (const Body& other : here_->bodies) {
    if (parts_.empty()) return;
    if (other.one_way() || other.highest > lowest || other.lowest < highest) continue;
    if (here_->has_polygons && (other.left >= x1 || other.right <= x0 || other.is_of_polygon_of(body)))
      continue;
    const auto [top0, bottom0] = other.range_at(x0, true);
    const auto [top1, bottom1] = other.range_at(x1, false);
    const bool is_flat = top0 == bottom0 && top1 == bottom1;
    if (&other == &body) {
      if (is_flat) take_out(parts_, x0, x1);
      continue;
    }
    if (is_flat) continue;
    // Of two equal lines that face the same way, the line of the later body is dropped.
    const bool later = &other < &body;
    const Span below_top = where_less(top0, top1, y0, y1, x0, x1, top ? later : true);
    const Span above_bottom = where_less(y0, y1, bottom0, bottom1, x0, x1, top ? true : later);
    const Span both = {std::max(below_top.from, above_bottom.from), std::min(below_top.to, above_bottom.to)};
    if (!both.empty()) take_out(parts_, both.from, both.to);
  }
}

void OutlineCompiler::take_out(std::vector<Interval>& parts, double from, double to) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Interval part = parts[i];
    if (to <= part.from || from >= part.to) continue;
    const Interval before{part.from, from}, after{to, part.to};
    const bool is_before = before.from < before.to, is_after = after.from < after.to;
    if (!is_before && !is_after) {
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i--));
      continue;
    }
    parts[i] = is_before ? before : after;
    if (is_before && is_after) parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(++i), after);
  }
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

void OutlineCompiler::compile_walls(Cell cell, std::vector<Piece<double>>& out) {
  compile_wall(tiles_.x_of(cell.x), true, cell, here_->left, before_->right, out);
  compile_wall(tiles_.x_of(cell.x + 1), false, cell, here_->right, after_->left, out);
  for (const double x : here_->cuts) {
    cover(*here_, x, false, before_cut_);
    cover(*here_, x, true, after_cut_);
    compile_wall(x, true, cell, after_cut_, before_cut_, out);
    compile_wall(x, false, cell, before_cut_, after_cut_, out);
  }
}

// The part of a vertical line in this cell with ground on one hand and none on the other.
void OutlineCompiler::compile_wall(double x, bool left, Cell cell, std::span<const Cover> ground,
                                   std::span<const Cover> beside, std::vector<Piece<double>>& out) {
  const double row0 = tiles_.y_of(cell.y), row1 = tiles_.y_of(cell.y + 1);
  for (const auto& [whole, origin] : ground) {
    if (whole.to <= row0 || whole.from >= row1) continue;
    parts_.clear();
    parts_.push_back(whole);
    for (const Cover& other : beside) take_out(parts_, other.part.from, other.part.to);
    for (const Interval& part : parts_) {
      const double y0 = std::max(part.from, row0), y1 = std::min(part.to, row1);
      if (y0 < y1) out.push_back(wall_at(x, y0, y1, left, origin, y0 == whole.from, y1 == whole.to));
    }
  }
}

// The tips of wedges: a body's top and bottom meet there, and no other ground continues.
void OutlineCompiler::compile_tips(Cell cell, std::vector<Piece<double>>& out) const {
  const double row0 = tiles_.y_of(cell.y), row1 = tiles_.y_of(cell.y + 1);
  for (const Body& body : here_->bodies) {
    if (body.is_full || body.one_way() || body.lowest < row0 || body.highest > row1) continue;
    if (body.is_of_polygon()) {
      compile_tip(body, {body.left, body.at_left.from}, true, cell, out);
      compile_tip(body, {body.right, body.at_right.from}, false, cell, out);
      continue;
    }
    for (const OutlineLine& line : body.lines(body.column->is_floor)) {
      if (line.y0 == line.y1) continue;
      compile_tip(body, body.corner + Vec2{line.x0, line.y0}, true, cell, out);
      compile_tip(body, body.corner + Vec2{line.x1, line.y1}, false, cell, out);
    }
  }
}

// The tip at the first, or the last, end of a line.
void OutlineCompiler::compile_tip(const Body& body, Vec2 at, bool first, Cell cell,
                                  std::vector<Piece<double>>& out) const {
  const bool here = at.x >= tiles_.x_of(cell.x) && at.x <= tiles_.x_of(cell.x + 1) &&
                    at.y >= tiles_.y_of(cell.y) && at.y <= tiles_.y_of(cell.y + 1);
  if (!here) return;
  const Interval range = body.range_at(at.x, first);
  if (at.y != range.from || at.y != range.to) return;
  if (!goes_on_at(at.x, at.y, !first))
    out.push_back(wall_at(at.x, at.y, at.y, first, body.origin, true, true));
}

// Whether there is ground right (or left) of a point of the current strip.
bool OutlineCompiler::goes_on_at(double x, double y, bool to_the_right) const {
  const std::vector<Body>& bodies = strip_beside(x, to_the_right).bodies;
  return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
    if (body.one_way() || y < body.highest || y > body.lowest || !body.is_beside(x, to_the_right))
      return false;
    const Interval range = body.range_at(x, to_the_right);
    return range.from <= y && y <= range.to && body.is_thick(x, to_the_right);
  });
}

// ---- Ends ----

void OutlineCompiler::mark_ends(Piece<double>& piece, Cell cell) const {
  if (piece.is_wall()) return;
  // A piece in several cells is marked at its ends, in the cells of these ends: only there the surroundings
  // are known.
  const auto is_near = [this, cell](double x, double y) {
    return x >= tiles_.x_of(cell.x) && x <= tiles_.x_of(cell.x + 1) && y >= tiles_.y_of(cell.y) &&
           y <= tiles_.y_of(cell.y + 1);
  };
  const bool near0 = is_near(piece.x0, piece.y0), near1 = is_near(piece.x1, piece.y1);
  const Next next0 = near0 ? next_of(piece, true) : Next{true, true};
  const Next next1 = near1 ? next_of(piece, false) : Next{true, true};
  piece.far0 = !near0;
  piece.far1 = !near1;
  piece.convex0 = !next0.outward && !next0.covers;
  piece.convex1 = !next1.outward && !next1.covers;
  piece.covered0 = next0.covers;
  piece.covered1 = next1.covers;
  piece.last0 = !next0.any;
  piece.last1 = !next1.any;
}

// The other lines that face the same way and begin where this one ends.
OutlineCompiler::Next OutlineCompiler::next_of(const Piece<double>& piece, bool first) const {
  const double x = first ? piece.x0 : piece.x1, y = first ? piece.y0 : piece.y1;
  const bool up = piece.facing == Facing::up, is_solid_floor = up && !piece.one_way && piece.origin >= 0;
  Next next;
  // dy: how much the line that goes on falls, seen from this end.
  const auto note = [&](double dy, bool is_passed_from_below) {
    if (is_solid_floor && is_passed_from_below && dy < 0) {
      next.covers = true;
      return;
    }
    next.any = true;
    next.outward = next.outward || (up ? dy <= 0 : dy >= 0);
  };
  for (const Body& body : strip_beside(x, !first).bodies) {
    if (y < body.highest || y > body.lowest || !body.has(up) || !body.is_beside(x, !first)) continue;
    for (const OutlineLine& in_tile : body.lines(up)) {
      const double x0 = in_tile.x0 + body.corner.x, x1 = in_tile.x1 + body.corner.x;
      const bool reaches_on = first ? x0 < x && x <= x1 : x0 <= x && x < x1;
      if (!reaches_on || in_tile.moved_at(body.corner, x) != y) continue;
      if (body.one_way() || body.is_thick(x, !first))
        note((first ? in_tile.y0 : in_tile.y1) + body.corner.y - y, body.one_way());
    }
  }
  for (const CurveEnds::End& end : curve_ends_.at({x, y}, !first)) {
    const Piece<double>& curve = curves_[end.piece];
    if (curve.facing == piece.facing) note(first ? curve.y0 - curve.y1 : curve.y1 - curve.y0, true);
  }
  next.covers = next.covers && !next.outward;
  return next;
}

}  // namespace talus
