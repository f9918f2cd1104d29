// BallSide: a side of the ground that a ball meets, and what two of them at one time do to its velocity. The
// answer does not depend on which of the two was met first, as rounding alone decides that (after Smith,
// Kaufman, Vouga, Tamstorf and Grinspun, "Reflections on simultaneous impact", 2012).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <talus/collision/geometry.h>

namespace talus {

// px; a ball that bounces to and fro between two sides comes nearer and nearer to both. So near, it touches
// both: far more than rounding, which would otherwise decide when that is.
inline constexpr double kTouch = 1.0 / 1073741824;
// Sides whose normals differ by less, in radians, are one: pieces of a curve that follow one another.
inline constexpr double kSameSide = 1.0 / 1048576;

template <class Real>
struct BallSide {
  using Vec = BasicVec2<Real>;
  Vec normal;   // unit, out of the ground
  Real bounce;  // the share of the speed into it that the ball leaves it with
  Real grip;    // the share of the speed along it that is left

  // px/frame: how fast a velocity leads into it.
  Real into(Vec velocity) const { return -dot(velocity, normal); }
  // The velocity after it, of one that leads into it.
  Vec reflect(Vec velocity) const {
    const Vec along{-normal.y, normal.x};
    return along * (dot(velocity, along) * grip) + normal * (into(velocity) * bounce);
  }
  // Whether what it leaves of a velocity does not lead into another side.
  bool stops(Vec velocity, const BallSide& other) const {
    const Vec left = velocity + normal * std::max<Real>(0, into(velocity));
    return other.into(left) <= (std::abs(velocity.x) + std::abs(velocity.y)) * Real(kSameSide);
  }
};

// Of two sides that a ball touches, keeps those that stop a velocity: `side` becomes the one, and `other` the
// second one if it takes both.
template <class Real>
void keep_what_stops(BasicVec2<Real> velocity, BallSide<Real>& side, std::optional<BallSide<Real>>& other) {
  if (!other) return;
  if (!side.stops(velocity, *other)) {
    if (!other->stops(velocity, side)) return;
    side = *other;
  }
  other.reset();
}

// The velocity after two sides that stop another one together.
template <class Real>
BasicVec2<Real> reflect_between(BasicVec2<Real> velocity, const BallSide<Real>& a, const BallSide<Real>& b) {
  const Real across = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  const Real from_a = a.into(velocity) * a.bounce, from_b = b.into(velocity) * b.bounce;
  return {(from_a * b.normal.y - from_b * a.normal.y) / across,
          (from_b * a.normal.x - from_a * b.normal.x) / across};
}

}  // namespace talus
