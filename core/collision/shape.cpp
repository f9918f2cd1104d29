// Says why a shape or a curve is invalid.
#include <talus/collision/shape.h>

#include <algorithm>
#include <cmath>

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
  const double center = weld(a.center.x), radius = weld(a.radius);
  if (weld(a.x0) >= center + radius || weld(a.x1) <= center - radius) return kWeldedAway;
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

}  // namespace

double weld(double coordinate) { return std::round(coordinate * kWeldParts) / kWeldParts; }

std::optional<std::string> problem_of(const TileShape& shape, TileSize tile) {
  using Kind = TileShape::Kind;
  const int most_heights = max_shape_heights(tile), highest = kMaxShapeTiles * tile.height;
  if (shape.tiles < 1 || shape.tiles > kMaxShapeTiles) return "must be 1 to 8 tiles wide";
  const auto most = static_cast<std::size_t>(most_heights);
  const int count = static_cast<int>(std::min(shape.heights.size(), most + 1));
  if (shape.kind == Kind::none || shape.kind == Kind::solid)
    return count == 0 ? Problem() : "has heights, which only a slope or a profile has";
  if (shape.kind == Kind::slope && count != 2) return "must have 2 heights";
  if (shape.kind == Kind::profile && (count < 3 || count > most_heights))
    return "must have 3 to " + std::to_string(most_heights) + " heights";
  for (const double height : shape.heights) {
    if (!std::isfinite(height)) return "has a height that is not a number";
    if (height < 0 || height > highest)
      return "has a height that is not from 0 to " + std::to_string(highest) + " px";
  }
  return {};
}

std::optional<std::string> problem_of(const Curve& curve) {
  return std::visit([](const auto& form) { return problem_of_form(form); }, curve.form);
}

double cells_passed(const Curve& curve, TileSize tile) {
  const Course course = std::visit([](const auto& form) { return course_of(form); }, curve.form);
  const double cells = course.parts + (course.width / tile.width + course.climb / tile.height);
  return curve.faces == Curve::Faces::both ? 2 * cells : cells;
}

}  // namespace talus
