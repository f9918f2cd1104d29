// Plain sentences: why a body went where it went.
#pragma once

#include <string>

#include "frame.h"

namespace talus {

struct Explanation {
  std::string sentence;  // "stopped by the left side of the tile at (12, 9) at 0.37 of the step; 1.9 px of
                         // motion left slid down": begins small and ends without a full stop
  std::string numbers;   // "normal (-0.45, -0.89), slope delta 0.44, floor at y 92.44"
};

// What a curve is called: curve "hill" by its name, or, without one, curve 2 by its number.
std::string name_of_curve(const Scene& scene, int curve);

// What a body met: "the tile at (12, 9)", "body 3", curve "hill".
std::string name_of(const Scene& scene, const Obstacle& other);

// What a contact did. index: of the frame's record (asserted).
Explanation explain_contact(const Frame& frame, std::size_t index);

// What a body wanted in the newest frame's step, what it got, and why: a few sentences. Empty at frame 0, and
// of a body that the frame has not.
std::string explain_step(const FrameView& view, int body);

}  // namespace talus
