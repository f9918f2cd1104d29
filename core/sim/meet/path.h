// FallPath: where a body is in a step, from its last event on.
#pragma once

#include <algorithm>
#include <cmath>

#include <talus/collision/geometry.h>

namespace talus {

// A body that nothing meets goes along a parabola.
struct FallPath {
  double time = 0;  // frames since the step began, of the event
  Vec2 place;       // px, top-left corner at that time
  Vec2 velocity;    // px/frame, at that time
  Vec2 pull;        // px/frame^2
  // px, the way that it goes until then.
  Vec2 way_to(double t) const {
    const double s = t - time;
    return velocity * s + pull * (s * s / 2);
  }
  Vec2 place_at(double t) const { return place + way_to(t); }
  Vec2 velocity_at(double t) const { return velocity + pull * (t - time); }
  // Whether it is off its chord until then by more than so many px.
  bool bends(double t, double px) const {
    const double s = t - time;
    return std::max(std::abs(pull.x), std::abs(pull.y)) * (s * s / 8) > px;
  }
  // The same path, as seen from another time on.
  FallPath from(double t) const { return t == time ? *this : FallPath{t, place_at(t), velocity_at(t), pull}; }
};

// The time until a gap closes, at least 0: gap, px; speed and gain, px/frame and px/frame^2, at which it
// closes. Infinite if it does not. None of its differences cancels.
inline double time_to_close(double gap, double speed, double gain) {
  const double inside = speed * speed + 2 * gain * gap;
  if (!(inside >= 0)) return HUGE_VAL;
  const double then = std::sqrt(inside);  // px/frame, at which it closes then
  if (speed > 0) return 2 * gap / (speed + then);
  return gain > 0 ? (then - speed) / gain : HUGE_VAL;
}

}  // namespace talus
