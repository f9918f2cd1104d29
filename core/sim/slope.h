// A slope for the solvers on `World`: a straight line across a box that reaches its top at one end.
#pragma once

#include <talus/collision/geometry.h>
#include <talus/level/flag_roles.h>

namespace talus {

struct Slope {
  Rect box;              // px
  double direction = 0;  // +1: rises to the right, or is level; -1: rises to the left; 0: no slope
  double low = 0;        // px, 0 to box.h, height of its lower end over the box's bottom
  bool ceiling = false;  // whether it hangs from the top of the box; heights are measured downwards then
  bool one_way = false;  // whether it stops only what comes from the open side
};

double slope_direction(TileRole role);
Vec2 slope_normal(const Slope& slope);  // unit, out of the slope

// How a box meets a slope. The foot is the higher of its two bottom corners above the floor. A ceiling is a
// floor mirrored at y = 0.
struct SlopeContact {
  enum class Kind {
    none,     // passes above the floor, or beside the slope
    surface,  // the foot meets the floor
    solid     // comes from below or from a side, and meets the slope's box
  };
  Kind kind = Kind::none;
  double ti = 0;       // like the fields below only for `surface`; fraction of the move
  Vec2 touch;          // px, top-left corner when the foot is on the floor
  Vec2 normal;         // unit; points straight up if the foot stands on the slope's high end
  Vec2 goal;           // px, end of the rest of the move along the surface
  double delta = 0;    // how far along the slope the foot is: 0 at its left end, 1 at its right end
  double floor_y = 0;  // px, y of the line at the foot
};

// Whether a box over or in a slope's columns is past its line by more than rounding: below a floor, above a
// ceiling.
bool is_past_line(const Slope& slope, const Rect& box);

// The mover's way to `goal`; it may start inside the slope's box.
SlopeContact meet_slope(const Slope& slope, const Rect& mover, Vec2 goal);

}  // namespace talus
