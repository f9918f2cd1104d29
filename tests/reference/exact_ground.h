// The reference for straight ground: exact rational arithmetic without rounding, and no code of the core. It
// is slow and simple: every query tests every part of the ground.
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

// A convex part of the ground: the area between a line and a level at x0..x1, the line alone, or a triangle.
struct Part {
  // from_above and from_below are for a line alone. A vertical line that stops from above stops from the
  // left.
  enum class Stops { everywhere, from_above, from_below };
  ExactPoint a, b;             // ends of the line; a.x <= b.x
  std::optional<Exact> level;  // y of the other side; empty: the line alone
  Stops stops = Stops::everywhere;
  std::vector<ExactPoint> corners = {};  // of a triangle; if there are any, the other fields are not used
};

struct ExactHit {
  Exact t;           // 0..1 of the motion; above 1: no hit
  std::size_t part;  // the first of the parts that are hit at that time
  // Whether the box came into a one-sided line from another side, at t at the latest, or passed just beyond
  // its end. Then a hit and a miss are both right.
  bool passed_a_line = false;
};

class ExactGround {
 public:
  std::vector<Part> parts;

  // Returns the earliest time from which on the moving box would be inside a part if nothing stopped it.
  // Touching without going in is no hit, and neither is a motion that ends exactly at a touch. A line that
  // stops only from above (below) does not stop boxes that come in at its ends or from the other side. A box
  // that begins at most `reach` px inside such a line still counts as outside.
  ExactHit cast(const ExactBox& box, const Exact& dx, const Exact& dy, const Exact& reach = 0) const;

  // Whether the inside of the box overlaps a part that stops everywhere.
  bool meets(const ExactBox& box) const;

  // Returns how far the box would have to move along the normal of a part's side to leave the part that it is
  // deepest in. Returns 0 if it is inside no part. Parts that are lines alone do not count.
  Exact depth(const ExactBox& box) const;

  // Returns the highest surface (least y) within the box's width that is not above its bottom; empty if there
  // is no ground there.
  std::optional<Exact> floor_below(const ExactBox& box) const;
  // The same at one x, for lines alone.
  std::optional<Exact> floor_below(const ExactPoint& point) const;
};

// To the precision of a long double.
long double wide(const Exact& value);

// A line's height at x; a.x < b.x.
Exact height_at(const Part& part, const Exact& x);

}  // namespace talus::reference
