// A slope as the solvers on `World` know it: a straight floor across a box, from corner to corner.
#pragma once

#include "../collision/geometry.h"
#include "../level/flag_roles.h"

namespace talus {

struct Slope {
  Rect box;              // px
  double direction = 0;  // +1 rises to the right, -1 to the left; 0: no slope
};

double slope_direction(TileRole role);
Vec2 slope_normal(const Slope& slope);  // unit, up and out of the slope

// How a box meets a slope. Its foot is the higher of its two bottom corners on the floor.
struct SlopeContact {
  enum class Kind {
    none,     // it passes above the floor, or beside the slope
    surface,  // its foot meets the floor
    solid     // it comes from below or from a side, and meets the slope as it would meet its box
  };
  Kind kind = Kind::none;
  double ti = 0;       // the fields below: of `surface` alone. Fraction of the move
  Vec2 touch;          // px, top-left corner with its foot on the floor
  Vec2 normal;         // unit; straight up where the foot stands on the slope's high end
  Vec2 goal;           // px, where the rest of the move leads along the surface
  double delta = 0;    // how far along the slope the foot is, 0 at its left end to 1 at its right end
  double floor_y = 0;  // px, of the floor under the foot
};

// The mover's way from where it is to `goal`; it may start inside the slope's box.
SlopeContact meet_slope(const Slope& slope, const Rect& mover, Vec2 goal);

}  // namespace talus
