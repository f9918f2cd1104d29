// The effects of rounding on the numbers of a cast.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <talus/collision/cast.h>

namespace talus {

// The error that a few roundings may give a number, relative to its size.
template <class Real>
inline constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();

// box.x moved by dx, and rounded so that both its sides are exact; a mirrored box goes to the mirrored place.
template <class Real>
inline Real moved_x(const BasicRect<Real>& box, Real dx) {
  if (dx == 0) return box.x;
  const Real center = box.x + box.w / 2 + dx;
  const Real left = center - box.w / 2, right = center + box.w / 2;
  return std::abs(right) > std::abs(left) ? right - box.w : left;
}

// Whether the motion is large enough to move the box at all; a smaller one counts as no motion.
template <class Real>
bool moves_sideways(const Cast<Real>& cast) {
  return moved_x(cast.box, cast.motion.x) != cast.box.x;
}

inline constexpr int kShortMotion = 16;  // px

// A few units in the last place of the coordinates involved: how deep rounding may have put a box into the
// ground. It is the same for mirror images, and for all motions of up to kShortMotion.
template <class Real>
[[gnu::always_inline]] inline Real rounding_slack(const Cast<Real>& cast) {
  const BasicRect<Real>& b = cast.box;
  const Real half_w = b.w / 2, half_h = b.h / 2;
  const Real reach = (std::abs(b.x + half_w) + half_w) + (std::abs(b.y + half_h) + half_h) +
                     std::max(std::abs(cast.motion.x) + std::abs(cast.motion.y), Real(kShortMotion));
  return reach * kRounding<Real>;
}

// The same for a line of this slope (px down for each px to the right): rounding puts a box that is on a
// steep line further above or below it.
template <class Real>
[[gnu::always_inline]] inline Real slack_on_line(Real slack, Real slope) {
  return slack * std::max<Real>(1, std::abs(slope));
}

// Whether a box can be cast: its sizes are 0 to kMaxCastSize, and all numbers finite and within
// kMaxCastReach.
template <class Real>
[[gnu::always_inline]] inline bool is_usable(const Cast<Real>& cast) {
  const BasicRect<Real>& b = cast.box;
  constexpr Real most = Real(kMaxCastSize);
  return b.w >= 0 && b.w <= most && b.h >= 0 && b.h <= most &&
         rounding_slack(cast) <= Real(kMaxCastReach) * kRounding<Real>;
}

}  // namespace talus
