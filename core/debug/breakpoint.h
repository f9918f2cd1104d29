// Breakpoints: conditions that stop the game, and the ready-made ones to choose from.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expression.h"

namespace talus {

struct Breakpoint {
  int id = 0;             // from 1, chosen by the owner of the list
  std::string condition;  // an expression with a truth value; see expression.h
  int body = 0;           // id of the body that the condition is about; 0: any body
  int count = 1;          // hits are numbered from 1; the game stops at this hit and at all later ones
  // true: every frame in which the condition holds is a hit; false: the first one of each stretch.
  bool each_frame = false;
  bool enabled = true;
  friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

// Ready-made conditions. Each one is a text that the user can see and change.
enum class BreakpointKind {
  touches_tile,
  touches_body,
  normal_range,
  slope_delta,
  grounded,
  penetration,
  speed,
  enters_cell,
  enters_rect,
  capped,
  parting
};
struct BreakpointField {
  std::string_view label;  // empty: the kind has no such field
  std::string_view unit;   // may be empty
  double standard = 0;     // the default
};
struct BreakpointKindInfo {
  BreakpointKind kind;
  std::string_view label;                 // "contact with a tile"
  std::array<BreakpointField, 4> fields;  // its fields come first, unused ones after them
  bool each_frame;                        // as Breakpoint::each_frame
};
std::span<const BreakpointKindInfo> breakpoint_kind_infos();  // in the order of the enum

// fields: one number for each field of the kind; a missing one has its default.
std::string condition_of(BreakpointKind kind, std::span<const double> fields);

// A breakpoint that is ready to judge frames.
class ArmedBreakpoint {
 public:
  static tl::expected<ArmedBreakpoint, ExpressionError> arm(const Breakpoint& breakpoint);

  const Breakpoint& breakpoint() const { return breakpoint_; }
  int frames_before() const { return condition_.frames_before() + 1; }  // frames that a view must hold

  // Returns the body for which the newest frame is a hit, the lowest id if there are several; 0 if the
  // condition is about no body; nothing if the frame is no hit. A condition does not hold for a body that the
  // frame does not have, and held for no body before the first frame.
  std::optional<int> hit(const FrameView& view) const;
  // The same for one body at a time: the number of bodies that the condition is asked about in the newest
  // frame, 1 if it is about no body; and what hit() returns if it is asked about that one alone, from 0.
  std::size_t questions(const FrameView& view) const;
  std::optional<int> hit(const FrameView& view, std::size_t question) const;

 private:
  ArmedBreakpoint(Breakpoint breakpoint, Expression condition)
      : breakpoint_(std::move(breakpoint)), condition_(std::move(condition)) {}
  bool hits_for(const FrameView& view, int body) const;
  bool held(const FrameView& view, int body, std::size_t back) const;

  Breakpoint breakpoint_;
  Expression condition_;
};

// The hit of a breakpoint that stops the game.
struct Stop {
  std::int64_t frame = 0;
  int breakpoint = 0;  // id
  int body = 0;        // id of the body for which it hit; 0: the condition is about no body
  int hit = 0;         // number of the hit, from 1; 0: hits are not counted, as no breakpoint needs it
  friend bool operator==(const Stop&, const Stop&) = default;
};

// The bodies that are judged in one go: a condition may take 1 ms for each.
inline constexpr std::size_t kBodiesAtOnce = 8;

// Counts the hits of several breakpoints in frames that follow one another.
class HitCounter {
 public:
  // Breakpoints that are not enabled are left out.
  explicit HitCounter(std::vector<ArmedBreakpoint> breakpoints);

  int frames_before() const { return frames_before_; }  // frames that a view must hold
  bool counts() const;                                  // whether a breakpoint does not stop at every hit
  bool empty() const { return breakpoints_.empty(); }
  int hits(int breakpoint) const;  // hits so far, by id; 0 for an unknown id

  // Judges the newest frame for so many more bodies, at least 1. The view must be the same until it returns
  // true: the frame is judged by all breakpoints, and its hits are counted.
  bool advance(const FrameView& view, std::size_t bodies);
  void forget_frame();  // the one that is judged in part
  // Of the frame that was judged last: the stop there, by the first breakpoint of the list that stops;
  // nothing: none does. And whether it was a hit of a breakpoint, by id; false for an unknown id.
  const std::optional<Stop>& stop() const { return stop_; }
  bool was_hit(int breakpoint) const;

 private:
  void count_hits(std::int64_t frame);

  std::vector<ArmedBreakpoint> breakpoints_;
  std::vector<int> hits_;                // one for each breakpoint
  std::vector<std::optional<int>> hit_;  // in the frame that is judged, the same: the body
  std::size_t breakpoint_ = 0;           // judges now
  std::size_t question_ = 0;             // its next one
  std::optional<Stop> stop_;
  int frames_before_ = 0;
};

}  // namespace talus
