// When and how two bodies meet that both go along parabolas.
#pragma once

#include <optional>

#include "contact_set.h"
#include "form.h"
#include "path.h"

namespace talus {

// A body on its way.
struct MovingBox {
  FallPath path;
  Vec2 size;          // px
  double radius = 0;  // px, as Form::radius
  Rect at(double t) const {
    const Vec2 place = path.place_at(t);
    return {place.x, place.y, size.x, size.y};
  }
  Form form_at(double t) const { return {at(t), radius}; }
  bool is_round() const { return radius > 0; }
};

struct PairMeeting {
  double time = 0;  // frames since the step began
  Vec2 normal;      // unit, out of the second body towards the first
};

// px; boxes that are so near to each other touch.
double touch_slack(const Rect& a, const Rect& b);

// px: holds every box that may touch this one, in part.
Rect touch_area(const Rect& box);

// The normal of two that touch, or overlap, out of the second: for boxes the axis on which they overlap
// least. Nothing if they are apart, or if only the corners of boxes touch. is_first: tells two in one place
// apart.
std::optional<Vec2> touching_normal(const Form& a, const Form& b, bool is_first);

// The first time, from `from` on and before `to`, at which they touch and come nearer. Boxes that overlap do
// not meet on the axes on which they do. still: px/frame; two that touch and approach no faster do not meet.
std::optional<PairMeeting> next_meeting(const MovingBox& a, const MovingBox& b, double from, double to,
                                        double still = kStill);

}  // namespace talus
