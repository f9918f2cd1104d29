// HitLog: the frames of a branch in which breakpoints hit, so that the hits up to any frame are known without
// counting again.
#pragma once

#include <optional>
#include <vector>

#include "debug/breakpoint.h"

namespace talus {

class HitLog {
 public:
  // Breakpoints that are not enabled are left out.
  explicit HitLog(const std::vector<ArmedBreakpoint>& breakpoints);

  // Judges up to so many more frames, fewer if they have more than kBodiesAtOnce bodies. Returns true when
  // this frame and all before it are judged. The source must be the same in every call, but may have grown.
  bool advance(const FrameSource& source, std::int64_t frame, std::int64_t most_frames);
  // Takes a frame that a counter with the same breakpoints has just judged, if it is the next one.
  void note(std::int64_t frame, const HitCounter& judged);
  // Hits in the frames 0 to this one; 0 for an unknown breakpoint. Nothing: not judged so far yet.
  std::optional<int> hits(int breakpoint, std::int64_t frame) const;

 private:
  void add(std::int64_t frame, const HitCounter& judged);

  struct Hits {
    int breakpoint;  // id
    std::vector<std::int64_t> frames;
  };
  HitCounter counter_;
  FrameHistory history_;
  std::vector<Hits> hits_;
  std::int64_t judged_ = -1;  // the last judged frame; -1: none
  bool is_judging_ = false;   // the frame after it is read, and judged in part
};

}  // namespace talus
