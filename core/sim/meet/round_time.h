// When a circle on a parabola comes to something that bends nowhere towards it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "../../collision/curve_time.h"
#include "contact_set.h"
#include "form.h"
#include "path.h"

namespace talus {

// The time of a touch, in frames since the way begins, and how it is then.
struct RoundTouch {
  double time = 0;
  Nearness near;
};

// px/frame^2: a circle that goes round something is on the brink of leaving it below that.
inline constexpr double kBrink = 1e-9;

// px/frame^2: how fast the gap of a circle that touches something closes. velocity and pull: px/frame and
// px/frame^2, as seen from it.
inline double closing_gain(const Nearness& near, Vec2 velocity, Vec2 pull) {
  const double across = dot(velocity, near.normal);
  return -dot(pull, near.normal) - near.bend * (dot(velocity, velocity) - across * across);
}

// px/frame^2: what closes the gap of two that touch faster than that keeps them together.
inline double least_gain(const Nearness& near) { return near.bend != 0 ? kBrink : kStill; }

// A way that is searched for a touch.
struct RoundSearch {
  FallPath way;            // of the first as seen from the other one, from time 0 on
  double most = 0;         // frames: the time before which it is looked for
  double slack = 0;        // px: two that are so near touch
  double still = kStill;   // px/frame: two that touch and approach no faster do not count
  bool is_hollow = false;  // the other one bends towards the first: it may meet beside the nearest point
};

// The same as below, by samples: for a way that may come back to what it touches, or meet it beside the
// nearest point, as in a hollow.
template <class NearAt>
std::optional<RoundTouch> first_touch_by_samples(const RoundSearch& search, double from, NearAt near_at) {
  const auto& [way, most, slack, still, is_hollow] = search;
  constexpr int kSamples = 4;
  const double start = near_at(from).gap;
  const double lift = start <= slack ? slack + std::max(0.0, -start) : 0;  // px
  const auto gap = [&](double time) { return near_at(time).gap + lift; };
  double clear = from;
  for (int i = 1; i <= kSamples; ++i) {
    const double time = i == kSamples ? most : from + (most - from) * i / kSamples;
    if (gap(time) >= 0) {
      clear = time;
      continue;
    }
    const double then = zero_between(clear, time, gap);
    const Nearness near = near_at(then);
    return -dot(way.velocity_at(then), near.normal) > still ? std::optional(RoundTouch{then, near})
                                                            : std::nullopt;
  }
  return std::nullopt;
}

// A touch found to the slack, to rounding: what is left of the gap is gone soon, or was gone just before.
template <class NearAt>
RoundTouch touch_to_rounding(const FallPath& way, RoundTouch touch, NearAt near_at) {
  constexpr double kSoon = 1e-6, kSame = 1e-12;  // frames
  constexpr int kMaxTries = 3;
  for (int i = 0; i < kMaxTries; ++i) {
    const double left = touch.near.gap / -dot(way.velocity_at(touch.time), touch.near.normal);
    if (!(std::abs(left) <= kSoon)) break;
    touch.time = std::max(0.0, touch.time + left);
    touch.near = near_at(touch.time);
    if (std::abs(left) <= kSame) break;
  }
  return touch;
}

// The first time at which they touch and come nearer. near_at(time): a Nearness. The plane through the
// nearest point parts the two until it is reached, so nothing is met before; the next plane is nearer to what
// is met.
template <class NearAt>
std::optional<RoundTouch> first_touch(const RoundSearch& search, NearAt near_at) {
  const auto& [way, most, slack, still, is_hollow] = search;
  constexpr int kMaxTries = 64;
  double time = 0;
  for (int i = 0; i < kMaxTries && time < most; ++i) {
    const Nearness near = near_at(time);
    const Vec2 velocity = way.velocity_at(time);
    const double speed = -dot(velocity, near.normal), gain = -dot(way.pull, near.normal);
    if (near.gap > slack) {
      if (is_hollow) return first_touch_by_samples(search, time, near_at);
      time += time_to_close(near.gap, speed, gain);
      continue;
    }
    // What bends away is only brushed by a circle that comes no deeper than that.
    const double opens = -closing_gain(near, velocity, way.pull);
    if (speed > still && opens > 0 && speed * speed / (2 * opens) - near.gap <= slack) {
      time += 2 * speed / opens;
      continue;
    }
    // It leaves the plane, and is back on it when its pull has turned it round.
    if (speed < -still && !is_hollow) {
      if (!(gain > 0)) return std::nullopt;
      time += -2 * speed / gain;
      continue;
    }
    const bool stays = speed >= -still && closing_gain(near, velocity, way.pull) > least_gain(near);
    if (!(speed > still) && !stays) return first_touch_by_samples(search, time, near_at);
    const RoundTouch touch =
        time > 0 && speed > still ? touch_to_rounding(way, {time, near}, near_at) : RoundTouch{time, near};
    return touch.time < most ? std::optional(touch) : std::nullopt;
  }
  // Beside an end that it has just left it may come nearer to what follows by tiny steps alone.
  return time < most ? first_touch_by_samples(search, time, near_at) : std::nullopt;
}

}  // namespace talus
