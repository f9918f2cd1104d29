// How a moving box meets a resting one: the sweep of a point against their Minkowski difference, clipped side
// by side after Liang and Barsky. All functions are pure; the order of every operation is part of the result.
#pragma once

#include <algorithm>
#include <cmath>

#include <talus/collision/geometry.h>

namespace talus {

// A faithful contact below this does not count: px where boxes are compared, a fraction of the move where
// times are.
inline constexpr double kDelta = 1e-10;

// The four sides of a box, px.
struct Sides {
  double left;
  double top;
  double right;
  double bottom;
};

inline Sides sides_of(const Rect& rect) { return {rect.x, rect.y, rect.x + rect.w, rect.y + rect.h}; }

// The part of a line inside of a box: it enters at ti1 through the side with normal `normal`, and leaves at
// ti2. The values before the call bound the line.
struct Clip {
  double ti1;
  double ti2;
  Vec2 normal;
};

// Clips the line from + t * d. Returns false if nothing is left. On a corner the vertical side wins.
bool clip_line(const Sides& box, Vec2 from, Vec2 d, Clip& clip);

// The sweep of a box that moves to `goal`.
struct Sweep {
  Rect box;
  Vec2 goal;
  Vec2 d;
  Sweep(const Rect& start, Vec2 end) : box(start), goal(end), d{end.x - start.x, end.y - start.y} {}
};

// The box around the whole path. The size is a difference that is added again later, as in bump.
inline Rect swept_bounds(const Sweep& sweep) {
  const Rect& box = sweep.box;
  const double left = std::min(sweep.goal.x, box.x);
  const double top = std::min(sweep.goal.y, box.y);
  const double right = std::max(sweep.goal.x + box.w, box.x + box.w);
  const double bottom = std::max(sweep.goal.y + box.h, box.y + box.h);
  return {left, top, right - left, bottom - top};
}

struct SweepContact {
  bool overlaps;
  double ti;
  Vec2 normal;
  Vec2 touch;
};

// The boxes overlap exactly if this box contains the origin. The mover's path becomes a ray from there.
inline Sides minkowski_difference(const Rect& mover, const Rect& other) {
  const double x = other.x - mover.x - mover.w;
  const double y = other.y - mover.y - mover.h;
  return {x, y, x + (mover.w + other.w), y + (mover.h + other.h)};
}

// True only if the exact tests below cannot find a contact; needs no division. A contact begins before t = 1
// and ends at t = -kDelta or later. Correctly rounded division is monotonic, so from = lo / d >= 1 follows
// from lo >= d. The factor 2 leaves room for the rounding of the product. NaN is never a miss.
inline bool misses_axis(double lo, double hi, double d) {
  // Bitwise, since a branch that is hard to predict costs more than both comparisons.
  if (d >= 0) return (lo >= d) | (hi < -2 * kDelta * d);
  return (hi <= d) | (lo > -2 * kDelta * d);
}

inline bool misses(const Sides& difference, Vec2 d) {
  const bool on_x = misses_axis(difference.left, difference.right, d.x);
  const bool on_y = misses_axis(difference.top, difference.bottom, d.y);
  return on_x | on_y;
}

// bump's contact for a sweep whose Minkowski difference did not miss. Returns false if there is none.
bool detect_faithful(const Sweep& sweep, const Sides& difference, SweepContact& contact);

// The contact with exact touch coordinates: flush boxes stay flush, and an overlap is left by its shortest
// way.
bool detect_robust(const Sweep& sweep, const Rect& other, SweepContact& contact);

// Squared distance of the centres, px².
inline double square_distance(const Rect& a, const Rect& b) {
  const double dx = a.x - b.x + (a.w - b.w) / 2;
  const double dy = a.y - b.y + (a.h - b.h) / 2;
  return dx * dx + dy * dy;
}

inline bool intersect(const Rect& a, const Rect& b) {
  return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

// Whether the point lies inside by more than kDelta.
inline bool contains(const Sides& box, Vec2 point) {
  return point.x - box.left > kDelta && point.y - box.top > kDelta && box.right - point.x > kDelta &&
         box.bottom - point.y > kDelta;
}

}  // namespace talus
