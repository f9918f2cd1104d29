// Plain sentences on why a body went where it went.
#pragma once

#include <string>

#include "frame.h"

namespace talus {

struct Explanation {
  // "stopped by the left side of the tile at (12, 9) at 0.37 of the step; 1.9 px of remaining motion slid
  // down": without capital and full stop.
  std::string sentence;
  std::string numbers;  // "normal (-0.45, -0.89), slope delta 0.44, floor at y 92.44"
};

// The name of a curve, as in: curve "hill"; without a name its number, as in: curve 2.
std::string name_of_curve(const Scene& scene, int curve);

// The name of what a body met: "the tile at (12, 9)", "body 3", curve "hill".
std::string name_of(const Scene& scene, const Obstacle& other);

// Explains a contact. index: of the frame's record (asserted).
Explanation explain_contact(const Frame& frame, std::size_t index);

// Says in a few sentences what a body wanted in the newest frame's step, what it got, and why. Empty at frame
// 0, and for a body that the frame does not have.
std::string explain_step(const FrameView& view, int body);

}  // namespace talus
