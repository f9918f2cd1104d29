// Trails: where bodies were in a range of frames.
#pragma once

#include <limits>
#include <vector>

#include "sim/timeline.h"

namespace talus {

struct TrailPoint {
  std::int64_t frame = 0;
  Rect box;  // px
};

// A trail is found by running its frames again. The last used ones are kept, so that a trail that moves on by
// a frame costs a step.
class Trails {
 public:
  static constexpr std::int64_t kMaxFrames = 600;  // of a trail: ten seconds

  // The body's boxes in those of the frames first..last that have it. Clamped to what the branch has run, and
  // to the last kMaxFrames of the range. If finding them takes long, there are fewer points at first, and
  // more with each call.
  const std::vector<TrailPoint>& trail(const Timeline& timeline, const Branch& branch, int body,
                                       std::int64_t first, std::int64_t last);
  // Whether a trail that was asked for since begin_turn() still lacks points.
  bool is_behind() const { return behind_; }
  void begin_turn() { behind_ = false; }
  // From now on a call takes as long as it needs, and returns all points.
  void take_time() { seconds_ = std::numeric_limits<double>::infinity(); }

 private:
  static constexpr std::size_t kMax = 4;  // trails kept

  struct Kept {
    int branch, revision, body;
    std::int64_t first, last;
    std::vector<TrailPoint> points;
  };
  std::vector<Kept> kept_;  // the last used one is first
  double seconds_ = 0.008;  // for running frames again, in one call
  bool behind_ = false;
};

}  // namespace talus
