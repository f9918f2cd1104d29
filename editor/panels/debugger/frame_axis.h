// Where frames are along a line on the screen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace talus {

struct FrameAxis {
  float left = 0, width = 1;         // px of the screen
  std::int64_t first = 0, last = 1;  // frames at both ends; last > first

  float x_of(double frame) const {
    const double share = (frame - static_cast<double>(first)) / static_cast<double>(last - first);
    return left + static_cast<float>(share) * width;
  }
  // The nearest frame of the axis.
  std::int64_t frame_at(float x) const {
    const double share = std::clamp<double>((x - left) / width, 0, 1);
    return first + std::llround(share * static_cast<double>(last - first));
  }
};

}  // namespace talus
