#include "track.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double kShort = 1e-5;  // px: over so little, a curve is a part of a circle

// px: how far a middle is past the nearer end of a side, or before it, along the side there.
double past_end(const GroundSide& side, Vec2 middle) {
  const Vec2 from = middle - side.from, to = middle - side.to;
  const bool is_first = is_first_nearer(side, middle);
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

std::optional<Vec2> Track::centre_for(const Form& circle) const {
  const Vec2 middle = circle.middle();
  if (!is_ground) return near(circle).bend == 0 ? std::nullopt : std::optional(nearest_point(form, middle));
  const GroundSide& side = sides.front();
  if (on_end) return nearer_end(side, middle);
  const bool is_arc = side.stretch != nullptr && side.stretch->kind == CurveStretch<double>::Kind::arc;
  return is_arc ? std::optional(Vec2{side.stretch->c[0], side.stretch->c[1]}) : std::nullopt;
}

// px: the way of a circle until a time, and on to the track. Of places, or of gaps, the rounding would be all
// that is left of a speed that is about to turn back.
Vec2 Track::way_along(const MovingBox& circle, double time, const Nearness& there) const {
  const Vec2 way = circle.path.way_to(time);
  const Form begin = circle.form_at(circle.path.time);
  Vec2 from;
  if (centre) {
    from = begin.middle() - *centre;
  } else {
    if (!(dot(way, way) <= kShort * kShort)) return way - there.normal * (there.gap - gap);
    const Nearness here = near(begin);
    if (here.bend == 0) return way - here.normal * dot(way, here.normal);
    from = here.normal * (1 / here.bend);
  }
  const Vec2 to = from + way;
  const double before = std::sqrt(dot(from, from)), after = std::sqrt(dot(to, to));
  return way - to * ((2 * dot(from, way) + dot(way, way)) / ((before + after) * after));
}

// The square of the speed follows from the way along gravity, as energy is kept.
Vec2 Track::take(MovingBox& circle, double time) const {
  const MovingBox before = circle;
  circle.path = before.path.from(time);
  const Nearness here = near(circle.form_at(time));
  const Vec2 onward = along(here.normal);
  // At the end of an end or a corner rounding may call the place the flat beyond: the speed is due there,
  // too.
  const bool is_curve = is_ground && sides.front().stretch != nullptr;  // it may be straight in one place
  if (here.bend == 0 && !on_end && !is_curve) {
    if (is_ground) put_on(sides.front(), circle);
    return onward;
  }
  circle.path.place = circle.path.place - here.normal * (here.gap - gap);
  const Vec2 way = way_along(before, time, here);
  const double straight = dot(circle.path.velocity, onward);
  const double driven = drive * (dot(way, onward) < 0 ? -1 : 1) * std::sqrt(dot(way, way));
  const double square =
      dot(before.path.velocity, before.path.velocity) + 2 * (rolls * dot(pull, way) + driven);
  // Where the path turns back, the energy may lead a little higher.
  const bool turns_back = straight * straight < square / 16;
  const double sign = (turns_back ? dot(before.path.velocity, onward) : straight) < 0 ? -1 : 1;
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

// Whether a normal has turned no more than twice as far as a path may.
bool Track::is_near_to(Vec2 begin, Vec2 now, bool is_round) {
  return dot(begin, now) > 0 && std::abs(dot(along(begin), now)) <= 2 * most_turn(is_round);
}

double Track::end(const MovingBox& circle, double most) const {
  const Nearness begin = near(circle.form_at(circle.path.time));
  const double turn = std::abs(begin.bend) * std::sqrt(dot(circle.path.velocity, circle.path.velocity));
  if (turn > 0) most = std::min(most, circle.path.time + longest(turn, circle.is_round()));
  const auto holds = [&](double time) {
    const Form now = circle.form_at(time);
    if (!goes_on(now)) return false;
    const Nearness here = near(now);
    // A curve may bend much more further on.
    if (!is_near_to(begin.normal, here.normal, circle.is_round())) return false;
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
