// Where a body was in a range of frames.
#pragma once

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
  // to the last kMostFrames of the range.
  const std::vector<TrailPoint>& trail(const Timeline& timeline, const Branch& branch, int body,
                                       std::int64_t first, std::int64_t last);

 private:
  static constexpr std::size_t kMost = 4;  // trails kept

  struct Kept {
    int branch, revision, body;
    std::int64_t first, last;
    std::vector<TrailPoint> points;
  };
  std::vector<Kept> kept_;  // the one used last is first
};

}  // namespace talus
