#include "form.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

Vec2 half_of(const Form& form) { return form.is_round() ? Vec2() : Vec2{form.box.w / 2, form.box.h / 2}; }

// The way out of a box around 0 that reaches `half` to each side, for a point inside.
Nearness out_of_middle(Vec2 point, Vec2 half, bool is_first) {
  const auto sign = [&](double at) { return at < 0 || (at == 0 && is_first) ? -1.0 : 1.0; };
  const Vec2 depth{half.x - std::abs(point.x), half.y - std::abs(point.y)};
  if (depth.x < depth.y) return {{sign(point.x), 0}, -depth.x};
  return {{0, sign(point.y)}, -depth.y};
}

}  // namespace

Vec2 nearest_point(const Form& form, Vec2 to) {
  const Vec2 half = half_of(form), way = to - form.middle();
  return form.middle() + Vec2{std::clamp(way.x, -half.x, half.x), std::clamp(way.y, -half.y, half.y)};
}

// The first one shrinks to a point, and the other one grows by it: to a box with round corners.
Nearness nearness(const Form& a, const Form& b, bool is_first) {
  const Vec2 half = half_of(a) + half_of(b), way = a.middle() - b.middle();
  const double radius = a.radius + b.radius;
  const Vec2 outside{way.x - std::clamp(way.x, -half.x, half.x), way.y - std::clamp(way.y, -half.y, half.y)};
  const double distance = std::sqrt(dot(outside, outside));
  if (!(distance > 0)) {
    Nearness inside = out_of_middle(way, half, is_first);
    inside.gap -= radius;
    return inside;
  }
  Nearness near{outside * (1 / distance), distance - radius};
  near.on_end = outside.x != 0 && outside.y != 0;
  const bool is_corner = near.on_end || (half.x == 0 && half.y == 0);
  if (is_corner) near.bend = 1 / radius;
  return near;
}

}  // namespace talus
