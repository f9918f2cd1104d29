// Says why a shape or a curve is invalid.
#include <talus/collision/shape.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace talus {
namespace {

using Problem = std::optional<std::string>;

constexpr const char* kWeldedAway = "has a width of zero when rounded to 1/256 px";

bool is_finite(double number) { return std::isfinite(number); }
bool is_finite(Vec2 point) { return std::isfinite(point.x) && std::isfinite(point.y); }

bool in_reach(double coordinate) { return std::abs(coordinate) <= kMaxCoordinate; }
bool in_reach(Vec2 point) { return in_reach(point.x) && in_reach(point.y); }

template <class... Numbers>
Problem problem_of_numbers(Numbers... numbers) {
  return (is_finite(numbers) && ...) ? Problem() : "has a number that is not finite";
}

// The points that a curve stays between.
template <class... Points>
Problem problem_of_reach(Points... points) {
  return (in_reach(points) && ...) ? Problem() : "reaches further than 16777216 px from the origin";
}

Problem problem_of_width(double x0, double x1) {
  if (x0 == x1) return "has a width of zero";
  if (x0 > x1) return "has its right end left of its left end";
  return weld(x0) < weld(x1) ? Problem() : kWeldedAway;
}

Problem first_of(const Problem& a, const Problem& b) { return a ? a : b; }

Problem problem_of_form(const Segment& s) {
  if (const Problem bad = problem_of_numbers(s.from, s.to)) return bad;
  if (s.from == s.to) return "has a length of zero";
  if (s.from.x > s.to.x) return "has its right end left of its left end";
  if (s.from.x == s.to.x && s.from.y > s.to.y) return "is vertical and has its lower end above its upper end";
  if (weld(s.from) == weld(s.to)) return "has a length of zero when rounded to 1/256 px";
  return problem_of_reach(s.from, s.to);
}

Problem problem_of_form(const Arc& a) {
  if (const Problem bad = problem_of_numbers(a.center, a.radius, a.x0, a.x1)) return bad;
  if (!(a.radius > 0)) return "has a radius that is not above zero";
  if (const Problem bad = problem_of_width(a.x0, a.x1)) return bad;
  if (a.x0 < a.center.x - a.radius || a.x1 > a.center.x + a.radius) return "has an end beyond its circle";
  const double far_y = a.center.y + (a.upper ? -a.radius : a.radius);
  return problem_of_reach(a.center, a.x0, a.x1, far_y);
}

Problem problem_of_form(const Parabola& p) {
  if (const Problem bad = problem_of_numbers(p.from, p.to, p.control_y)) return bad;
  return first_of(problem_of_width(p.from.x, p.to.x), problem_of_reach(p.from, p.to, p.control_y));
}

Problem problem_of_form(const Cubic& c) {
  if (const Problem bad = problem_of_numbers(c.from, c.to, c.from_slope, c.to_slope)) return bad;
  if (const Problem bad = problem_of_width(c.from.x, c.to.x)) return bad;
  // from an end to the control point of the same curve in Bezier form
  const double third = (c.to.x - c.from.x) / 3;
  return problem_of_reach(c.from, c.to, c.from.y + c.from_slope * third, c.to.y - c.to_slope * third);
}

Problem problem_of_form(const Sine& s) {
  if (const Problem bad = problem_of_numbers(s.x0, s.x1, s.middle, s.amplitude, s.wavelength, s.origin))
    return bad;
  if (const Problem bad = problem_of_width(s.x0, s.x1)) return bad;
  if (!(s.wavelength > 0)) return "has a wavelength that is not above zero";
  if ((s.x1 - s.x0) / s.wavelength > kMaxWaves) return "has more than 4096 waves";
  return problem_of_reach(s.x0, s.x1, s.origin, s.wavelength, s.middle - s.amplitude, s.middle + s.amplitude);
}

Problem problem_of_form(const Polyline& p) {
  if (const Problem bad = problem_of_numbers(p.x0, p.x1)) return bad;
  if (p.ys.size() < 2) return "needs at least 2 heights";
  if (p.ys.size() > kMaxPolylineHeights) return "has more than 65536 heights";
  for (const double y : p.ys) {
    if (const Problem bad = first_of(problem_of_numbers(y), problem_of_reach(y))) return bad;
  }
  if (const Problem bad = first_of(problem_of_width(p.x0, p.x1), problem_of_reach(p.x0, p.x1))) return bad;
  const double step = (weld(p.x1) - weld(p.x0)) / static_cast<double>(p.ys.size() - 1);
  return step * kWeldParts >= 1 ? Problem() : "has its heights closer to one another than 1/256 px";
}

// The extent of a curve: `parts` that only rise or only fall, over a width, up or down by `climb` in total;
// px.
struct Course {
  double parts = 1, width = 0, climb = 0;
};

Course course_of(const Segment& s) { return {1, s.to.x - s.from.x, std::abs(s.to.y - s.from.y)}; }

Course course_of(const Arc& a) {
  const auto height_at = [&](double x) {
    const double u = x - a.center.x;
    return std::sqrt(std::max(0.0, (a.radius - u) * (a.radius + u)));
  };
  const double h0 = height_at(a.x0), h1 = height_at(a.x1);
  const bool has_top = a.x0 < a.center.x && a.center.x < a.x1;
  return {2, a.x1 - a.x0, has_top ? 2 * a.radius - h0 - h1 : std::abs(h1 - h0)};
}

// A Bezier curve goes up and down by no more than its control points do.
Course course_of(const Parabola& p) {
  return {2, p.to.x - p.from.x, std::abs(p.control_y - p.from.y) + std::abs(p.to.y - p.control_y)};
}

Course course_of(const Cubic& c) {
  const double third = (c.to.x - c.from.x) / 3;
  const double y1 = c.from.y + c.from_slope * third, y2 = c.to.y - c.to_slope * third;
  return {3, 3 * third, std::abs(y1 - c.from.y) + std::abs(y2 - y1) + std::abs(c.to.y - y2)};
}

Course course_of(const Sine& s) {
  const double quarters = 4 * (s.x1 - s.x0) / s.wavelength;
  const double parts = std::ceil(quarters) + 1;
  return {parts, s.x1 - s.x0, std::min(parts, 2 * quarters) * std::abs(s.amplitude)};
}

Course course_of(const Polyline& p) {
  Course course{static_cast<double>(p.ys.size()), p.x1 - p.x0};
  for (std::size_t i = 1; i < p.ys.size(); ++i) course.climb += std::abs(p.ys[i] - p.ys[i - 1]);
  return course;
}

// ---- Shapes of tiles ----

Problem problem_of_heights(const TileShape& shape, TileSize tile) {
  const int most_heights = max_shape_heights(tile), highest = kMaxShapeTiles * tile.height;
  const auto most = static_cast<std::size_t>(most_heights);
  const int count = static_cast<int>(std::min(shape.heights.size(), most + 1));
  if (shape.kind == TileShape::Kind::slope && count != 2) return "must have 2 heights";
  if (shape.kind == TileShape::Kind::profile && (count < 3 || count > most_heights))
    return "must have 3 to " + std::to_string(most_heights) + " heights";
  for (const double height : shape.heights) {
    if (!std::isfinite(height)) return "has a height that is not a number";
    if (height < 0 || height > highest)
      return "has a height that is not from 0 to " + std::to_string(highest) + " px";
  }
  return {};
}

// A welded point in 1/256 px. Whole numbers of this size make exact products.
struct WeldedPoint {
  std::int64_t x, y;
  friend bool operator==(const WeldedPoint&, const WeldedPoint&) = default;
};

// Twice the area of the triangle; its sign tells on which side of the line from a to b the point c is.
std::int64_t turn_of(WeldedPoint a, WeldedPoint b, WeldedPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int sign_of(std::int64_t number) { return (number > 0) - (number < 0); }

// Whether c, on the line through a and b, is between them.
bool is_between(WeldedPoint a, WeldedPoint b, WeldedPoint c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
         c.y <= std::max(a.y, b.y);
}

// Whether the lines from a to b and from c to d have a common point.
bool sides_meet(WeldedPoint a, WeldedPoint b, WeldedPoint c, WeldedPoint d) {
  const int abc = sign_of(turn_of(a, b, c)), abd = sign_of(turn_of(a, b, d));
  const int cda = sign_of(turn_of(c, d, a)), cdb = sign_of(turn_of(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) ||
         (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
}

// Whether two sides meet elsewhere than neighbours do in their common end.
bool crosses_itself(const std::vector<WeldedPoint>& points) {
  const std::size_t count = points.size();
  const auto at = [&](std::size_t i) { return points[i % count]; };
  for (std::size_t i = 0; i < count; ++i) {
    const WeldedPoint before = at(i), corner = at(i + 1), after = at(i + 2);
    const bool turns_back = turn_of(before, corner, after) == 0 &&
                            (is_between(before, corner, after) || is_between(corner, after, before));
    if (turns_back) return true;
    for (std::size_t k = i + 2; k < count && k - i < count - 1; ++k) {
      if (sides_meet(before, corner, at(k), at(k + 1))) return true;
    }
  }
  return false;
}

// The sides of a part of a larger area may be shorter than 1/256 px.
Problem problem_of_part(const TileShape& polygon) {
  const std::vector<Vec2>& points = polygon.points;
  if (polygon.lines.size() != points.size()) return "has not one line for each point";
  bool is_upright = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [left, right] = std::minmax(points[i].x, points[(i + 1) % points.size()].x);
    const Segment& line = polygon.lines[i];
    if (!is_finite(line.from) || !is_finite(line.to)) return "has a line with an end that is not a number";
    if (line.from.x > left || line.to.x < right) return "has a line that is shorter than its side";
    is_upright = is_upright && left == right;
  }
  return is_upright ? "has no area" : Problem();
}

Problem problem_of_polygon(const TileShape& polygon, TileSize tile) {
  const std::vector<Vec2>& points = polygon.points;
  if (points.size() < 3) return "needs at least 3 points";
  if (points.size() > kMaxPolygonPoints) return "has more than 256 points";
  const auto is_near = [](double at, int side) {
    return at >= -kMaxShapeTiles * side && at <= (kMaxShapeTiles + 1) * side;
  };
  std::vector<WeldedPoint> welded;
  for (const Vec2 point : points) {
    if (!is_finite(point)) return "has a point that is not a number";
    if (!is_near(point.x, tile.width) || !is_near(point.y, tile.height))
      return "has a point that is further than 8 tiles from its tile";
    welded.push_back({std::llround(point.x * kWeldParts), std::llround(point.y * kWeldParts)});
  }
  if (!polygon.lines.empty()) return problem_of_part(polygon);
  for (std::size_t i = 0; i < welded.size(); ++i) {
    if (welded[i] == welded[(i + 1) % welded.size()])
      return "has two neighbouring points at the same place, rounded to 1/256 px";
  }
  const bool is_line = std::all_of(welded.begin(), welded.end(), [&](WeldedPoint point) {
    return turn_of(welded[0], welded[1], point) == 0;
  });
  if (is_line) return "has no area";
  return crosses_itself(welded) ? "has sides that cross or touch one another" : Problem();
}

Problem problem_of_conveyor(double speed) {
  if (!std::isfinite(speed)) return "has a conveyor whose speed is not a number";
  if (std::abs(speed) > kMaxConveyor) return "has a conveyor that is faster than 64 px a frame";
  return {};
}

Problem problem_of_group(const TileShape& group, TileSize tile) {
  using Kind = TileShape::Kind;
  if (group.parts.empty()) return "has no parts";
  if (group.parts.size() > kMaxGroupParts) return "has more than 64 parts";
  std::size_t points = 0;
  for (const TileShape& part : group.parts) {
    if (part.kind == Kind::group) return "has a part that is a group";
    if (part.kind == Kind::none) return "has a part that is nothing";
    if (part.conveyor != 0) return "has a part that is a conveyor, which only the whole can be";
    if (const Problem bad = problem_of(part, tile)) return "has a part that " + *bad;
    points += part.points.size();
  }
  return points <= kMaxGroupPoints ? Problem() : "has more than 1024 points";
}

}  // namespace

double weld(double coordinate) { return std::round(coordinate * kWeldParts) / kWeldParts; }

std::optional<std::string> problem_of(const TileShape& shape, TileSize tile) {
  using Kind = TileShape::Kind;
  if (shape.tiles < 1 || shape.tiles > kMaxShapeTiles) return "must be 1 to 8 tiles wide";
  if (shape.side == TileShape::Side::left || shape.side == TileShape::Side::right)
    return std::string("stops bodies on its ") + (shape.side == TileShape::Side::left ? "left" : "right") +
           " side alone, which no solver can";
  if (const Problem bad = problem_of_conveyor(shape.conveyor)) return bad;
  if (shape.kind != Kind::polygon && !shape.points.empty()) return "has points, which only a polygon has";
  if (shape.kind != Kind::polygon && !shape.lines.empty()) return "has lines, which only a polygon has";
  if (shape.kind != Kind::group && !shape.parts.empty()) return "has parts, which only a group has";
  if (shape.kind == Kind::slope || shape.kind == Kind::profile) return problem_of_heights(shape, tile);
  if (!shape.heights.empty()) return "has heights, which only a slope or a profile has";
  if (shape.kind == Kind::polygon) return problem_of_polygon(shape, tile);
  return shape.kind == Kind::group ? problem_of_group(shape, tile) : Problem();
}

std::optional<std::string> problem_of(const Curve& curve) {
  if (const Problem bad = problem_of_conveyor(curve.conveyor)) return bad;
  return std::visit([](const auto& form) { return problem_of_form(form); }, curve.form);
}

double cells_passed(const Curve& curve, TileSize tile) {
  const Course course = std::visit([](const auto& form) { return course_of(form); }, curve.form);
  const double cells = course.parts + (course.width / tile.width + course.climb / tile.height);
  return curve.faces == Curve::Faces::both ? 2 * cells : cells;
}

}  // namespace talus
