// The answers that the report measures against, in long double. Plain and slow, without any code of the
// solvers.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include <talus/level/tuning.h>

namespace talus {

using Wide = long double;

// A floor as a function of x, px. Falls on it are measured only where its slope is less than 1.25.
struct LineFloor {
  Wide x0, y0, x1, y1;
};
struct ArcFloor {  // the upper half of a circle
  Wide center_x, center_y, radius;
};
struct SineFloor {  // as Sine in collision/shape.h
  Wide middle, amplitude, wavelength, origin;
};
using TrueFloor = std::variant<LineFloor, ArcFloor, SineFloor>;

// The y of the highest point of the floor from `left` to `right`: where the bottom of a box rests.
Wide highest(const TrueFloor& floor, Wide left, Wide right);

struct WideBox {
  Wide x, y, w, h;
};

// When a falling box meets the floor, as a fraction of its motion; above 1 if not in this motion. The box
// must fall faster than the floor does under it, so that there is at most one time.
Wide time_of_impact(const TrueFloor& floor, const WideBox& box, Wide dx, Wide dy);

// The solvers' integrator for a ball on an endless straight floor.
struct WideBall {
  Wide x, y, vx, vy;  // of the lowest corner; px, px/frame
};
// One frame cut into `parts`: pull, move, bounce by the normal; the rest of the motion slides. The floor goes
// through `through` and has this slope.
void step_ball(WideBall& ball, const Tuning& tuning, Wide through_x, Wide through_y, Wide slope, int parts);

// Closed-form physics: a ball dropped at rest bounces for ever on a level floor, under the fall of the
// tuning: gravity if there is any, else the article's. The frames of a free flight lie exactly on its curve,
// so only the bounce is measured. Answers by frame, from 0, for the ball's bottom; px, y down, 0 at the
// floor.
std::vector<double> bouncing(const Tuning& tuning, double start, int frames);

}  // namespace talus
