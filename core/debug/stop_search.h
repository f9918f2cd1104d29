// Runs to the next stop of a recording, or back to the one before, a few frames at a time.
#pragma once

#include "breakpoint.h"

namespace talus {

enum class SearchDirection { forwards, backwards };

// Both directions find the same stops, since hits are numbered from frame 0 on: what runs back over a stop
// comes to where a run forwards would have stopped. So where a breakpoint counts, a search begins at frame 0;
// else it begins beside `from`, and backwards takes blocks of frames, each of them read forwards.
class StopSearch {
 public:
  // from: the frame to go on from, which is not itself a stop; -1 forwards: from before the first one.
  StopSearch(std::vector<ArmedBreakpoint> breakpoints, std::int64_t from, SearchDirection direction);

  // Judges up to so many frames of the source, fewer where it has to run to them first, which must be the
  // same in every call but may have grown. True: the search is at its end. To cancel it, drop it.
  bool advance(const FrameSource& source, std::int64_t frames);
  bool is_done() const { return is_done_; }
  // Share of the frames there are that are judged, 0 to 1.
  double progress(const FrameSource& source) const;
  const std::optional<Stop>& found() const { return found_; }  // once it is done; nothing: there is no stop

 private:
  void judge(const FrameSource& source);
  void begin_block_before(std::int64_t end);

  HitCounter counter_;
  FrameHistory history_;
  const std::int64_t from_;
  const SearchDirection direction_;
  std::int64_t next_ = 0;       // the frame to judge
  std::int64_t block_ = 0;      // first frame of the block under way
  std::int64_t block_end_ = 0;  // backwards: the frame after its last
  std::int64_t judged_ = 0;     // frames, so far
  bool is_done_ = false;
  std::optional<Stop> found_;
};

}  // namespace talus
