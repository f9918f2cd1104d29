// When a point that moves straight meets a curve: closed forms for circles and parabolas, and iterations that
// stay in a bracket for what has none.
#pragma once

#include <algorithm>
#include <cmath>

#include <talus/collision/geometry.h>

namespace talus {

// a few are enough; the limit ends iterations that rounding keeps going
inline constexpr int kMaxIterations = 100;

// The time at which a point that moves by `motion` in one unit of time meets a circle around the origin. For
// a point that starts on the circle the result is NaN or near 0. from_outside: whether the point comes from
// there.
template <class Real>
Real circle_time(BasicVec2<Real> from, BasicVec2<Real> motion, Real radius, bool from_outside) {
  const Real a = dot(motion, motion), b = dot(from, motion);
  const Real c = (from.x - radius) * (from.x + radius) + from.y * from.y;
  const Real root = std::sqrt(std::max<Real>(b * b - a * c, 0));
  // A root can be written in two ways. This is the one that does not subtract nearly equal numbers.
  if (from_outside) return b < 0 ? c / (root - b) : (-b - root) / a;
  return b < 0 ? (root - b) / a : -c / (root + b);
}

// The first time t >= 0 at which gap + rate t + bend t^2 is 0.
template <class Real>
Real parabola_time(Real gap, Real rate, Real bend) {
  const Real root = std::sqrt(std::max<Real>(rate * rate - 4 * bend * gap, 0));
  return rate <= 0 ? 2 * gap / (root - rate) : (-rate - root) / (2 * bend);
}

// The place between a and b where f falls through zero; f(a) >= 0 > f(b). Newton's method; a step that would
// leave the bracket halves it instead. rounding: the error that f may have.
template <class Real, class F, class Derivative>
Real newton_between(Real a, Real b, F f, Derivative derivative, Real rounding) {
  Real t = b;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Real ft = f(t);
    (ft >= 0 ? a : b) = t;
    Real next = t - ft / derivative(t);
    if (!(next >= a && next <= b)) next = a + (b - a) / 2;
    if (std::abs(ft) <= rounding || next == t) return next;
    t = next;
  }
  return t;
}

// The same for an f whose derivative is not at hand: regula falsi (Illinois). It ends at a place where f is
// still >= 0.
template <class Real, class F>
Real zero_between(Real a, Real b, F f) {
  Real fa = f(a), fb = f(b);
  for (int i = 0; i < kMaxIterations && fa > 0; ++i) {
    Real t = (a * fb - b * fa) / (fb - fa);
    if (!(t > a && t < b)) t = a + (b - a) / 2;
    if (!(t > a && t < b)) break;
    const Real ft = f(t);
    if (ft >= 0) {
      a = t, fa = ft, fb /= 2;
    } else {
      b = t, fb = ft, fa /= 2;
    }
  }
  return a;
}

}  // namespace talus
