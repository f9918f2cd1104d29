// HitLog: in which frames of a run breakpoints hit, so that their hits up to any frame are known without
// counting again.
#pragma once

#include <optional>
#include <vector>

#include "debug/breakpoint.h"

namespace talus {

class HitLog {
 public:
  // Those that are not enabled are left out.
  explicit HitLog(const std::vector<ArmedBreakpoint>& breakpoints);

  // Judges up to so many frames more; true when this frame and all before it are judged. The source must be
  // the same in every call, but may have grown.
  bool advance(const FrameSource& source, std::int64_t frame, std::int64_t most_frames);
  // Takes a frame that somebody has read for something else, if it is the next one.
  void note(const FrameView& view);
  // Hits in the frames 0 to this one; 0 of a breakpoint that is not there. Nothing: not yet judged so far.
  std::optional<int> hits(int breakpoint, std::int64_t frame) const;

 private:
  void judge(const FrameView& view);

  struct Hits {
    int breakpoint;  // id
    std::vector<std::int64_t> frames;
  };
  HitCounter counter_;
  FrameHistory history_;
  std::vector<Hits> hits_;
  std::int64_t judged_ = -1;  // the last frame that was; -1: none
};

}  // namespace talus
