// Form: what of a body's box is solid: all of it, or a circle in it.
#pragma once

#include <talus/collision/geometry.h>

namespace talus {

struct Form {
  Rect box;           // px
  double radius = 0;  // px, of a circle that stands on the middle of the box's bottom; 0: all of it is solid
  bool is_round() const { return radius > 0; }
  // px, of what is solid.
  Vec2 middle() const { return {box.x + box.w / 2, is_round() ? box.bottom() - radius : box.y + box.h / 2}; }
};

// How near a circle is to something else.
struct Nearness {
  Vec2 normal;      // unit, from the nearest point of the other one towards the middle of the first one
  double gap = 0;   // px; less than 0: they overlap
  double bend = 0;  // 1/px, of the middle's way along the other one; over 0: it bends away from the normal
  bool on_end = false;  // the nearest point is a corner, or the end of a piece of ground
};

// px: the point of a form's box, or the middle of its circle, that is nearest to another point.
Vec2 nearest_point(const Form& form, Vec2 to);

// How near two forms are, of which one is round at least. is_first: tells two in the same place apart.
Nearness nearness(const Form& a, const Form& b, bool is_first);

}  // namespace talus
