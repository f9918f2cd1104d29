// BreakpointSearch: runs to the next frame of a recording at which a breakpoint stops, or back to the
// previous one, a few frames at a time.
#pragma once

#include "breakpoint.h"

namespace talus {

enum class SearchDirection { forwards, backwards };

// Both directions find the same stops, as hits are numbered from frame 0 on: a search backwards stops where
// a search forwards would have stopped. So if a breakpoint counts hits, a search begins at frame 0. Otherwise
// it begins beside `from`; backwards it takes blocks of frames and reads each of them forwards.
class BreakpointSearch {
 public:
  // from: the frame to go on from, which is not a stop itself. Forwards, -1 means before the first frame.
  BreakpointSearch(std::vector<ArmedBreakpoint> breakpoints, std::int64_t from, SearchDirection direction);

  // Judges up to `frames` frames of the source, fewer if it has to run to them first, or if they have more
  // than kBodiesAtOnce bodies. The source must be the same in every call but may have grown. Returns true at
  // the end of the search. To cancel a search, drop it.
  bool advance(const FrameSource& source, std::int64_t frames);
  bool is_done() const { return is_done_; }
  // Share of the source's frames that are judged, 0 to 1.
  double progress(const FrameSource& source) const;
  // Valid once the search is done; nothing: there is no stop.
  const std::optional<Stop>& found() const { return found_; }

 private:
  void judge(const FrameSource& source);
  void begin_block_before(std::int64_t end);

  HitCounter counter_;
  FrameHistory history_;
  const std::int64_t from_;
  const SearchDirection direction_;
  std::int64_t next_ = 0;       // the frame to judge
  std::int64_t block_ = 0;      // first frame of the current block
  std::int64_t block_end_ = 0;  // backwards: the frame after the block's last one
  std::int64_t judged_ = 0;     // frames judged so far
  bool is_judging_ = false;     // the frame to judge is read, and judged in part
  bool is_done_ = false;
  std::optional<Stop> found_;
};

}  // namespace talus
