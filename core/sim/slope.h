// A slope as the solvers on `World` know it: a straight line across a box, that reaches its top at one end.
#pragma once

#include <talus/collision/geometry.h>
#include <talus/level/flag_roles.h>

namespace talus {

struct Slope {
  Rect box;              // px
  double direction = 0;  // +1 rises to the right, -1 to the left, or is level; 0: no slope
  double low = 0;        // px, 0 to box.h, height of its lower end over the bottom of the box
  bool ceiling = false;  // it hangs from the top of the box, and heights are measured downwards from there
  bool one_way = false;  // stops only what comes from the open side
};

double slope_direction(TileRole role);
Vec2 slope_normal(const Slope& slope);  // unit, out of the slope

// How a box meets a slope. Its foot is the higher of its two bottom corners on the floor. A ceiling is a
// floor seen in a mirror that lies on y = 0.
struct SlopeContact {
  enum class Kind {
    none,     // it passes above the floor, or beside the slope
    surface,  // its foot meets the floor
    solid     // it comes from below or from a side, and meets the slope as it would meet its box
  };
  Kind kind = Kind::none;
  double ti = 0;       // the fields below: of `surface` alone. Fraction of the move
  Vec2 touch;          // px, top-left corner with its foot on the floor
  Vec2 normal;         // unit; upright where the foot stands on the slope's high end
  Vec2 goal;           // px, where the rest of the move leads along the surface
  double delta = 0;    // how far along the slope the foot is, 0 at its left end to 1 at its right end
  double floor_y = 0;  // px, of the line at the foot
};

// The mover's way from where it is to `goal`; it may start inside the slope's box.
SlopeContact meet_slope(const Slope& slope, const Rect& mover, Vec2 goal);

}  // namespace talus
