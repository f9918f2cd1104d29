// Breakpoints: their list; they are judged while the game runs, and searched for in a branch.
#pragma once

#include <optional>
#include <vector>

#include "debug/breakpoint_search.h"
#include "hit_log.h"

namespace talus {

// "Breakpoint 1 at frame 33, body 2." For a search without a breakpoint: "They part at frame 33, body 2."
std::string text_of(const Stop& stop);
// Instead of the id of a breakpoint: the body was stopped by what it met.
inline constexpr int kStoppedBody = -1;

class Breakpoints {
 public:
  // --- The list. A change forgets the counted hits.
  const std::vector<Breakpoint>& all() const { return all_; }
  void put(Breakpoint breakpoint);  // replaces the one with its id; id 0: a new one
  void remove(int breakpoint);
  // Hits in the frames 0 to this one; 0 for an unknown or faulty breakpoint. Nothing: count() still has to
  // count them.
  std::optional<int> hits(int breakpoint, std::int64_t frame) const {
    return log_ ? log_->hits(breakpoint, frame) : 0;
  }
  // Counts the hits of so many more frames, fewer if they have many bodies. Returns true when those up to
  // this frame are counted.
  bool count(const FrameSource& source, std::int64_t frame, std::int64_t most_frames) {
    return !log_ || log_->advance(source, frame, most_frames);
  }
  void forget_hits();  // another branch is compared now

  // --- While it runs. source: the frames of the shown branch.
  // Whether the hits up to this frame are counted; if not, counts those of so many more frames, fewer if they
  // have many bodies. Needed before the step from there is judged. Takes no time if no breakpoint counts.
  bool ready(const FrameSource& source, std::int64_t frame, std::int64_t most_frames);
  // Begins to judge the frame after the one that it was ready for.
  void begin_frame(const FrameSource& source, std::int64_t frame);
  // Whether that frame is judged in part.
  bool is_judging(std::int64_t frame) const { return judging_ == frame; }
  // Judges the frame that was begun for kBodiesAtOnce more bodies. Returns true when it is judged, and puts
  // the stop there, or nothing, into `stop`.
  bool judge_more(std::optional<Stop>& stop);
  void forget_frames();  // the frames belong to another branch now, or the breakpoints have changed

  // --- Searching
  void search(std::int64_t from, SearchDirection direction);
  // For a condition that is not one of the list: forwards from frame 0, or back before a frame.
  void search_first(ArmedBreakpoint condition);
  void search_last(ArmedBreakpoint condition, std::int64_t before);
  void cancel_search() { search_.reset(); }
  bool searching() const { return search_.has_value(); }
  SearchDirection direction() const { return direction_; }
  double progress(const FrameSource& source) const { return search_ ? search_->progress(source) : 1; }
  // Continues; returns true when it has just ended: found() has the result.
  bool advance_search(const FrameSource& source, std::int64_t most_frames);
  const std::optional<Stop>& found() const { return found_; }

 private:
  std::vector<ArmedBreakpoint> armed() const;
  void forget_frame();  // the one that is judged in part

  std::vector<Breakpoint> all_;
  int last_id_ = 0;
  HitCounter counter_{{}};
  std::optional<HitLog> log_;            // set once there was a breakpoint
  std::optional<FrameHistory> history_;  // set while there are breakpoints
  std::int64_t judged_ = -1;             // the last judged frame; -1: none
  std::optional<std::int64_t> judging_;  // the frame that is judged in part, the newest of the history

  std::optional<BreakpointSearch> search_;
  SearchDirection direction_ = SearchDirection::forwards;
  std::optional<Stop> found_;
};

}  // namespace talus
