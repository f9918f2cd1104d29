#include "track.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

// px: only what is further past an end has left it. Putting a circle on its track may move it by rounding.
constexpr double kPast = 1e-9;

// px: how far a middle is past the nearer end of a side, or before it, along the side there.
double past_end(const GroundSide& side, Vec2 middle) {
  const Vec2 from = middle - side.from, to = middle - side.to;
  const bool is_first = dot(from, from) < dot(to, to);
  const Vec2 onward =
      side.stretch == nullptr ? side.along : side.stretch->tangent_at(is_first ? side.from.x : side.to.x);
  return std::abs(dot(is_first ? from : to, onward));
}

}  // namespace

Nearness Track::near(const Form& circle) const {
  if (is_ground) return nearness(sides.front(), circle.middle(), circle.radius).near;
  return nearness(circle, form, true);
}

bool Track::goes_on(const Form& circle) const {
  if (!is_ground) return nearness(circle, form, true).on_end == on_end;
  return std::all_of(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(followed),
                     [&](const GroundSide& side) {
                       const SideNearness here = nearness(side, circle.middle(), circle.radius);
                       return here.near.on_end == on_end || past_end(side, circle.middle()) <= kPast;
                     });
}

// The square of the speed follows from the way along gravity, as energy is kept.
Vec2 Track::take(MovingBox& circle, double time) const {
  const FallPath before = circle.path;
  circle.path = before.from(time);
  const Nearness here = near(circle.form_at(time));
  const Vec2 onward = along(here.normal);
  // At the end of an end or a corner rounding may call the place the flat beyond: the speed is due there,
  // too.
  if (here.bend == 0 && !on_end) {
    if (is_ground) put_on(sides.front(), circle);
    return onward;
  }
  circle.path.place = circle.path.place - here.normal * (here.gap - gap);
  const Vec2 way = circle.path.place - before.place;
  const double straight = dot(circle.path.velocity, onward), sign = straight < 0 ? -1 : 1;
  const double driven = drive * (dot(way, onward) < 0 ? -1 : 1) * std::sqrt(dot(way, way));
  const double square = dot(before.velocity, before.velocity) + 2 * (rolls * dot(pull, way) + driven);
  circle.path.velocity = onward * (sign * std::sqrt(std::max(square, 0.0)));
  if (square < 0) go_down(circle, onward, -square);
  return onward;
}

// A parabola may lead a little higher than the energy does. missing: px^2/frame^2, of the square of the
// speed.
void Track::go_down(MovingBox& circle, Vec2 onward, double missing) const {
  const double steep = 2 * rolls * dot(pull, onward);
  if (!(std::abs(steep) > missing)) return;
  circle.path.place = circle.path.place + onward * (missing / steep);
  const Nearness here = near(circle.form_at(circle.path.time));
  circle.path.place = circle.path.place - here.normal * (here.gap - gap);
}

double Track::end(const MovingBox& circle, double most) const {
  // A parabola is near to what is bent only for so long.
  constexpr double kMostTurn = 1.0 / 8;  // radians
  const double turn = std::abs(near(circle.form_at(circle.path.time)).bend) *
                      std::sqrt(dot(circle.path.velocity, circle.path.velocity));
  if (turn > 0) most = std::min(most, circle.path.time + kMostTurn / turn);
  const auto holds = [&](double time) {
    const Form now = circle.form_at(time);
    if (!goes_on(now)) return false;
    const Nearness here = near(now);
    if (here.bend <= 0 || !is_alone || here.on_end != on_end) return true;
    MovingBox there = circle;
    take(there, time);
    const Vec2 velocity = there.path.velocity;
    return dot(pull, here.normal) + here.bend * dot(velocity, velocity) <= 0;
  };
  if (holds(most)) return most;
  double from = circle.path.time, to = most;
  constexpr int kHalvings = 48;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = from + (to - from) / 2;
    (holds(middle) ? from : to) = middle;
  }
  return to;
}

}  // namespace talus
