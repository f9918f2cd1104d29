// Debugger: what stops the game, which expressions are plotted over the branch, and what that is compared
// with. It looks at the session's timeline and never changes it. Long work is done a little at a time.
#pragma once

#include <optional>
#include <vector>

#include "breakpoints.h"
#include "debug/compare.h"
#include "plot_list.h"
#include "session/run/shown_frame.h"
#include "session/run/side_by_side.h"
#include "session/run/work_share.h"

namespace talus {

class Debugger {
 public:
  const Breakpoints& breakpoints() const { return breakpoints_; }
  const PlotList& plots() const { return plots_; }
  const SideBySide& side_by_side() const { return side_; }

  void put(Breakpoint breakpoint) { breakpoints_.put(std::move(breakpoint)); }
  void remove_breakpoint(int id) { breakpoints_.remove(id); }
  void put(std::size_t index, PlotText plot) { plots_.put(index, std::move(plot)); }
  void remove_plot(std::size_t index) { plots_.remove(index); }
  void compare_with(std::optional<Variant> variant);
  // Searches forwards after the shown frame, or back before it.
  void search(const Timeline& timeline, SearchDirection direction);
  // Searches the last stretch of frames, up to the shown one, in which a body is stopped: it stays where it
  // is though a key moves it, or, without keys, has just lost its speed to the side. 0: no body.
  void search_last_stop(const Timeline& timeline, int body);
  // Searches the first frame in which a body is further than this, px, from the same one on the other side.
  void search_parting(double threshold);
  // A larger distance, px, counts as parted; finite and 0 or more.
  void set_parting(double threshold);
  double parting() const { return parting_; }
  void cancel_search() { breakpoints_.cancel_search(); }

  // --- While it runs
  // The timeline belongs to another level now: the comparison ends, and the breakpoints, which are about
  // bodies and cells of the old level, are switched off.
  void forget_timeline();
  // Brings everything up to the timeline; call it whenever that has changed.
  void follow(const Timeline& timeline, const Level& level);
  // Whether a step may be made: the shown frame is judged, and the hits of the breakpoints up to it are
  // counted. If not, it counts some more of them.
  bool may_step(const Timeline& timeline);
  // Judges the frame after a step for a few ms. Returns whether the game stops there. Costs nothing without
  // breakpoints.
  bool stops_at(const Timeline& timeline, const Level& level);
  // Goes on for a few ms, if a frame with many bodies is not judged yet. Returns whether the game stops
  // there.
  bool still_stops_at(const Timeline& timeline);
  // Spends a few ms on remaining work. Returns the frame that a search has just found, if there is one.
  std::optional<std::int64_t> advance(const Timeline& timeline, const Level& level, int chosen_body);

  // Whether work remains after the last call of advance(), or was found by a look since.
  bool is_busy() const { return is_busy_ || !shown_frame_.is_read() || other_is_behind_; }
  bool searching() const { return breakpoints_.searching(); }
  double search_progress() const { return breakpoints_.progress(source()); }
  bool search_failed() const { return search_failed_; }      // whether the last search ended without a stop
  const std::optional<Stop>& stop() const { return stop_; }  // the last stop
  // The shown frame with those before it, and with the other side once that is there.
  FrameView view(const Timeline& timeline) const;
  // The ground there, whatever the solver. If the scene has none, compiling it takes time by the size of the
  // level.
  const std::shared_ptr<const Terrain>& ground(const Timeline& timeline) const;
  const std::vector<Stage>& stages(const Timeline& timeline, int body) const;
  // The other side's state in the shown frame; null: there is no other side, or it has not come so far.
  const State* other_state(const Timeline& timeline) const;
  // Distance in px of the chosen body from the other side; null: there is no other side.
  const Series* parting_series() const;
  // The same frame of the other side, with the step that led to it; null as for other_state().
  const Frame* other_frame(const Timeline& timeline) const;
  // The last frame of the other side; nothing: there is no other side.
  std::optional<std::int64_t> other_end() const;
  // The first frame in which the sides have parted, as far as it is known: for a variant by more than
  // parting(), for a branch by any difference.
  std::optional<std::int64_t> parting_frame(const Timeline& timeline) const;
  // How far a variant has been run, 0 to 1, while it is behind the shown frame.
  std::optional<double> comparing_progress(const Timeline& timeline) const;

 private:
  // The shown branch with the other side; it must be followed (asserted).
  ComparedFrames source() const { return {*shown_.get(), side_.frames()}; }
  // The id of the other side, if that has the shown frame; else 0.
  int other_id(const Timeline& timeline) const { return side_.has(timeline.frame()) ? side_.id() : 0; }
  bool advance_plots(const Timeline& timeline, int chosen_body);
  bool advance_parting();
  void forget_parting();

  Breakpoints breakpoints_;
  PlotList plots_, parting_plot_;
  SideBySide side_;
  FollowedFrames shown_;
  int branch_ = 0, revision_ = 0;  // of the followed branch
  int side_id_ = 0;

  double parting_ = 0.01;
  std::optional<BreakpointSearch> parting_search_;
  std::int64_t parting_searched_ = -1;  // the last searched frame
  std::optional<std::int64_t> parting_frame_;

  mutable ShownFrame shown_frame_;  // caches
  mutable FollowedFrames other_frames_;
  mutable Frame other_frame_;
  mutable int other_id_ = 0;              // the side of that frame
  mutable bool other_is_behind_ = false;  // the other side's frame was wanted, and is still to be run

  std::optional<Stop> stop_;
  bool search_failed_ = false;
  bool is_busy_ = false;
  WorkShare frames_{16, 0.002};    // frames to run or judge in one go
  WorkShare counted_{256, 0.004};  // frames whose hits are counted before a step
};

}  // namespace talus
