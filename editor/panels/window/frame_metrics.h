// FrameMetrics: the cost of the window's last frames.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace talus {

struct FrameCost {
  double interface_ms = 0;  // processor time for panels, canvases and overlays
  double opengl_ms = 0;     // for handing them to OpenGL, without showing the picture; 0 offscreen
  int vertices = 0;
  int draw_calls = 0;
};

class FrameMetrics {
 public:
  static constexpr std::size_t kFrames = 120;  // number of kept frames

  void note(const FrameCost& cost) {
    costs_[next_] = cost;
    next_ = (next_ + 1) % kFrames;
    count_ = std::min(count_ + 1, kFrames);
  }
  void clear() { count_ = next_ = 0; }
  std::size_t frames() const { return count_; }
  // Over the kept frames; all 0 before the first one.
  using Part = double FrameCost::*;
  double median_ms(Part part = &FrameCost::interface_ms) const {
    std::vector<double> times = all_ms(part);
    if (times.empty()) return 0;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
  }
  double max_ms(Part part = &FrameCost::interface_ms) const {
    const std::vector<double> times = all_ms(part);
    return times.empty() ? 0 : *std::max_element(times.begin(), times.end());
  }
  FrameCost last() const { return count_ == 0 ? FrameCost{} : costs_[(next_ + kFrames - 1) % kFrames]; }

 private:
  std::vector<double> all_ms(Part part) const {
    std::vector<double> times;
    for (std::size_t i = 0; i < count_; ++i) times.push_back(costs_[i].*part);
    return times;
  }
  std::array<FrameCost, kFrames> costs_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace talus
