// Where a body was in a range of frames.
#pragma once

#include <limits>
#include <vector>

#include "sim/timeline.h"

namespace talus {

struct TrailPoint {
  std::int64_t frame = 0;
  Rect box;  // px
};

// A trail is found by running its frames again; those asked for last are kept, so that one that moves on by a
// frame takes a step.
class Trails {
 public:
  static constexpr std::int64_t kMostFrames = 600;  // of a trail: ten seconds

  // The body's boxes in the frames first..last in which it is there. Clamped to what the branch has run, and
  // to the last kMostFrames of the range. Where it takes long to find them, there are fewer points at first,
  // and more with each call.
  const std::vector<TrailPoint>& trail(const Timeline& timeline, const Branch& branch, int body,
                                       std::int64_t first, std::int64_t last);
  // Whether a trail that was asked for since begin_turn() has points still to be found.
  bool is_behind() const { return behind_; }
  void begin_turn() { behind_ = false; }
  // From now on a call takes as long as it needs, and gives all points.
  void take_time() { seconds_ = std::numeric_limits<double>::infinity(); }

 private:
  static constexpr std::size_t kMost = 4;  // trails kept

  struct Kept {
    int branch, revision, body;
    std::int64_t first, last;
    std::vector<TrailPoint> points;
  };
  std::vector<Kept> kept_;  // the one used last is first
  double seconds_ = 0.008;  // that a call spends on running frames again
  bool behind_ = false;
};

}  // namespace talus
