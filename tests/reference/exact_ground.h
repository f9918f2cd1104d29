// The reference for straight ground: exact rational arithmetic, no rounding at all, and no code of the core.
// Slow and plain: every question looks at every part of the ground.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

namespace talus::reference {

using Exact = mpq_class;

// Rounds to 1/256, halves away from zero.
Exact rounded_to_256th(const Exact& value);

struct ExactPoint {
  Exact x, y;
};

struct ExactBox {
  Exact x, y, w, h;
  ExactBox grown(const Exact& by) const { return {x - by, y - by, w + 2 * by, h + 2 * by}; }
};

// A convex part of the ground: what is between a line and a level at x0..x1; or the line alone.
struct Part {
  // The latter two only as a line; an upright one that stops from above stops from the left.
  enum class Stops { everywhere, from_above, from_below };
  ExactPoint a, b;             // ends of the line; a.x <= b.x
  std::optional<Exact> level;  // y of the other side; none: the line alone
  Stops stops = Stops::everywhere;
};

struct ExactHit {
  Exact t;           // 0..1 of the motion; above 1: none
  std::size_t part;  // the first of those that are hit then
  // Whether the box came, at t at the latest, into a line that stops from one side only and from another
  // side; or just past its end, so that either is right.
  bool passed_a_line = false;
};

class ExactGround {
 public:
  std::vector<Part> parts;

  // The earliest time from which on the moving box is inside of a part, so that without stopping there it
  // would go in. Touching without going in is no hit; nor is what ends exactly at a touch. A line that stops
  // only from above (below) lets through what comes in at its sides or from the other one; a box that begins
  // at most `reach` px inside of such a line counts as outside of it still.
  ExactHit cast(const ExactBox& box, const Exact& dx, const Exact& dy, const Exact& reach = 0) const;

  // Whether the box's inside meets a part that stops everywhere.
  bool meets(const ExactBox& box) const;

  // How far the box would have to move along the normal of a part's side to leave the part it is deepest in.
  // 0: it is inside of none. The part must have an inside.
  Exact depth(const ExactBox& box) const;

  // The highest surface (least y) within the box's width that is not above its bottom; none: no ground there.
  std::optional<Exact> floor_below(const ExactBox& box) const;
  // The same at one x, of the lines alone.
  std::optional<Exact> floor_below(const ExactPoint& point) const;
};

// To the precision of a long double.
long double wide(const Exact& value);

// A line's height at x; a.x < b.x.
Exact height_at(const Part& part, const Exact& x);

}  // namespace talus::reference
