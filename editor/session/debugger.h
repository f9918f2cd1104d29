// Debugger: what stops a run, what is watched in it, and what it is compared with. Looks at the timeline of
// the session, and never changes it; long work is done a little at a time.
#pragma once

#include <optional>
#include <vector>

#include "debug/compare.h"
#include "shown_frame.h"
#include "side_by_side.h"
#include "stops.h"
#include "watches.h"

namespace talus {

class Debugger {
 public:
  const Stops& stops() const { return stops_; }
  const Watches& watches() const { return watches_; }
  const SideBySide& side_by_side() const { return side_; }

  void put(Breakpoint breakpoint) { stops_.put(std::move(breakpoint)); }
  void remove_breakpoint(int id) { stops_.remove(id); }
  void put(std::size_t index, WatchText watch) { watches_.put(index, std::move(watch)); }
  void remove_watch(std::size_t index) { watches_.remove(index); }
  void compare_with(std::optional<Variant> variant);
  // Forwards after the shown frame, or back before it.
  void search(const Timeline& timeline, SearchDirection direction);
  // The first frame in which a body is further than this, px, from the same one on the other side.
  void search_parting(double threshold);
  void cancel_search() { stops_.cancel_search(); }

  // --- While it runs
  // Brings everything up to the timeline; to be called whenever that has changed.
  void follow(const Timeline& timeline, const Level& level);
  // Whether a step may be made: the hits of the breakpoints up to the shown frame are counted. If not, it
  // counts some more of them.
  bool may_step(const Timeline& timeline);
  // Judges the frame that a step has just led to: whether it stops there. Without breakpoints it costs
  // nothing.
  bool stops_at(const Timeline& timeline, const Level& level);
  // Spends a few ms on what is still to be done; the frame that a search has just found, if it has.
  std::optional<std::int64_t> advance(const Timeline& timeline, const Level& level, int chosen_body);

  // Whether the last call of advance() left something to do.
  bool is_busy() const { return is_busy_; }
  bool searching() const { return stops_.searching(); }
  double search_progress() const { return stops_.progress(source()); }
  bool search_failed() const { return search_failed_; }      // the last one came to its end without a stop
  const std::optional<Stop>& stop() const { return stop_; }  // where it was stopped last
  // The shown frame with those before it, and the other side's, once that is there.
  FrameView view(const Timeline& timeline) const;
  const std::vector<Stage>& stages(const Timeline& timeline, int body) const;
  // The other side's state in the shown frame; null: there is none, or it has not come that far.
  const State* other_state(const Timeline& timeline) const;
  const Series* parting_series() const;  // px from the other side, of the chosen body; null: there is none

 private:
  // The shown run with the other side; it must be followed (asserted).
  ComparedFrames source() const { return {*shown_.get(), side_.frames()}; }
  bool advance_plots(const Timeline& timeline, int chosen_body);

  Stops stops_;
  Watches watches_, parting_watch_;
  SideBySide side_;
  FollowedFrames shown_;
  int branch_ = 0, revision_ = 0;  // of what is followed

  mutable ShownFrame shown_frame_;  // a cache

  std::optional<Stop> stop_;
  bool search_failed_ = false;
  bool is_busy_ = false;
};

}  // namespace talus
