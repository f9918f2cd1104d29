// The ends of each form of curve.
#include "curve_span.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace talus {
namespace {

CurveSpan span(const Segment& s) { return {s.from, s.to}; }
CurveSpan span(const Parabola& p) { return {p.from, p.to}; }
CurveSpan span(const Cubic& c) { return {c.from, c.to}; }
CurveSpan span(const Polyline& p) {
  if (p.ys.empty()) return {{p.x0, 0}, {p.x1, 0}};
  return {{p.x0, p.ys.front()}, {p.x1, p.ys.back()}};
}
CurveSpan span(const Arc& a) {
  const auto at = [&](double x) {
    const double u = x - a.center.x;
    const double height = std::sqrt(std::max(0.0, (a.radius - u) * (a.radius + u)));
    return Vec2{x, a.center.y + (a.upper ? -height : height)};
  };
  return {at(a.x0), at(a.x1)};
}
CurveSpan span(const Sine& s) {
  const auto at = [&](double x) {
    const double turns = (x - s.origin) / s.wavelength;
    return Vec2{x, s.middle + s.amplitude * std::sin(2 * std::numbers::pi * (turns - std::round(turns)))};
  };
  return {at(s.x0), at(s.x1)};
}

}  // namespace

CurveSpan span_of(const Curve& curve) {
  return std::visit([](const auto& form) { return span(form); }, curve.form);
}

}  // namespace talus
