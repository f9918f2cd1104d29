// When and how two boxes meet that both go along parabolas.
#pragma once

#include <optional>

#include "path.h"

namespace talus {

// A box on its way.
struct MovingBox {
  FallPath path;
  Vec2 size;  // px
  Rect at(double t) const {
    const Vec2 place = path.place_at(t);
    return {place.x, place.y, size.x, size.y};
  }
};

struct PairMeeting {
  double time = 0;  // frames since the step began
  Vec2 normal;      // unit, out of the second box towards the first
};

// px; boxes that are so near to each other touch.
double touch_slack(const Rect& a, const Rect& b);

// px: holds every box that may touch this one, in part.
Rect touch_area(const Rect& box);

// The normal of two boxes that touch, or overlap: the axis on which they overlap least. Nothing if they are
// apart, or if only their corners touch. is_first: tells two boxes in the same place apart.
std::optional<Vec2> touching_normal(const Rect& a, const Rect& b, bool is_first);

// The first time, from `from` on and before `to`, at which they touch and come nearer. Boxes that overlap do
// not meet on the axes on which they do.
std::optional<PairMeeting> next_meeting(const MovingBox& a, const MovingBox& b, double from, double to);

}  // namespace talus
