// Debugger: what stops a run, what is watched in it, and what it is compared with. Looks at the timeline of
// the session, and never changes it; long work is done a little at a time.
#pragma once

#include <optional>
#include <vector>

#include "debug/compare.h"
#include "session/run/shown_frame.h"
#include "session/run/side_by_side.h"
#include "session/run/work_share.h"
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
  // More than this, px, counts as parted; finite and 0 or more.
  void set_parting(double threshold);
  double parting() const { return parting_; }
  void cancel_search() { stops_.cancel_search(); }

  // --- While it runs
  // The timeline is another level's now: nothing is compared any more, and the breakpoints, whose bodies and
  // cells were the old one's, are switched off.
  void forget_run();
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

  // Whether the last call of advance() left something to do, or what was looked at since did.
  bool is_busy() const { return is_busy_ || !shown_frame_.is_read() || other_is_behind_; }
  bool searching() const { return stops_.searching(); }
  double search_progress() const { return stops_.progress(source()); }
  bool search_failed() const { return search_failed_; }      // the last one came to its end without a stop
  const std::optional<Stop>& stop() const { return stop_; }  // where it was stopped last
  // The shown frame with those before it, and the other side's, once that is there.
  FrameView view(const Timeline& timeline) const;
  // The ground there, whatever the solver. Compiling it takes time by the size of the level, where the scene
  // has none.
  const std::shared_ptr<const Terrain>& ground(const Timeline& timeline) const;
  const std::vector<Stage>& stages(const Timeline& timeline, int body) const;
  // The other side's state in the shown frame; null: there is none, or it has not come that far.
  const State* other_state(const Timeline& timeline) const;
  const Series* parting_series() const;  // px from the other side, of the chosen body; null: there is none
  // The same frame of the other side, with the step that led there; null as other_state().
  const Frame* other_frame(const Timeline& timeline) const;
  // The last frame that the other side has; nothing: there is no other side.
  std::optional<std::int64_t> other_end() const;
  // The first frame in which the sides have parted: as far as it is known, of a comparison with a variant by
  // more than parting(), with a branch at all.
  std::optional<std::int64_t> parting_frame(const Timeline& timeline) const;
  // How far a variant has been run, 0 to 1, while it is behind what is shown.
  std::optional<double> comparing_progress(const Timeline& timeline) const;

 private:
  // The shown run with the other side; it must be followed (asserted).
  ComparedFrames source() const { return {*shown_.get(), side_.frames()}; }
  // The run of the other side, where that has the shown frame; 0: it has not.
  int other_run(const Timeline& timeline) const { return side_.has(timeline.frame()) ? side_.run() : 0; }
  bool advance_plots(const Timeline& timeline, int chosen_body);
  bool advance_parting();
  void forget_parting();

  Stops stops_;
  Watches watches_, parting_watch_;
  SideBySide side_;
  FollowedFrames shown_;
  int branch_ = 0, revision_ = 0;  // of what is followed
  int side_run_ = 0;

  double parting_ = 0.01;
  std::optional<StopSearch> parting_search_;
  std::int64_t parting_searched_ = -1;  // the last frame that was
  std::optional<std::int64_t> parting_frame_;

  mutable ShownFrame shown_frame_;  // caches
  mutable FollowedFrames other_frames_;
  mutable Frame other_frame_;
  mutable int other_run_ = 0;             // of that frame
  mutable bool other_is_behind_ = false;  // it was asked for, and is still to be run to

  std::optional<Stop> stop_;
  bool search_failed_ = false;
  bool is_busy_ = false;
  WorkShare frames_{16, 0.002};    // that are run or judged at once
  WorkShare counted_{2000, 0.02};  // whose hits are counted before a step
};

}  // namespace talus
