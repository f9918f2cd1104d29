// Breakpoints: conditions that stop a run, and the ready ones to choose from.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expression.h"

namespace talus {

struct Breakpoint {
  int id = 0;               // from 1, chosen by the owner of the list
  std::string condition;    // see expression.h; a truth value
  int body = 0;             // id of the body that it is asked about; 0: any
  int count = 1;            // its hits are numbered from 1; it stops at this one and those after it
  bool each_frame = false;  // hits in every frame in which the condition holds, not only where it begins to
  bool enabled = true;
  friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

// The conditions that a user need not write. Each is a text, so that it can be seen and changed.
enum class StopKind {
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
struct StopField {
  std::string_view label;  // empty: no field
  std::string_view unit;   // may be empty
  double standard = 0;     // the default
};
struct StopKindInfo {
  StopKind kind;
  std::string_view label;           // "contact with a tile"
  std::array<StopField, 4> fields;  // those that it has come first
  bool each_frame;                  // as Breakpoint::each_frame
};
std::span<const StopKindInfo> stop_kind_infos();  // in the order of the enum

// fields: as many numbers as the kind has fields; one that is missing has its default.
std::string condition_of(StopKind kind, std::span<const double> fields);

// A breakpoint that is ready to judge frames.
class ArmedBreakpoint {
 public:
  static tl::expected<ArmedBreakpoint, ExpressionError> arm(const Breakpoint& breakpoint);

  const Breakpoint& breakpoint() const { return breakpoint_; }
  int frames_before() const { return condition_.frames_before() + 1; }  // that a view must hold

  // The body for which the newest frame is a hit, the first by id if there are several; 0 where the condition
  // is about no body; nothing: no hit. A condition holds of none that the frame has not, and held of none
  // before the first frame.
  std::optional<int> hit(const FrameView& view) const;

 private:
  ArmedBreakpoint(Breakpoint breakpoint, Expression condition)
      : breakpoint_(std::move(breakpoint)), condition_(std::move(condition)) {}
  bool hits_for(const FrameView& view, int body) const;
  bool held(const FrameView& view, int body, std::size_t back) const;

  Breakpoint breakpoint_;
  Expression condition_;
};

struct Stop {
  std::int64_t frame = 0;
  int breakpoint = 0;  // id
  int body = 0;        // id of the body for which it hit; 0: the condition is about none
  int hit = 0;         // its number, from 1; 0: nobody counted, as no breakpoint needs it
  friend bool operator==(const Stop&, const Stop&) = default;
};

// Counts the hits of several breakpoints in frames that follow one another.
class HitCounter {
 public:
  explicit HitCounter(std::vector<ArmedBreakpoint> breakpoints);  // those that are not enabled are left out

  int frames_before() const { return frames_before_; }  // that a view must hold
  bool counts() const;                                  // whether one stops not at every hit
  bool empty() const { return breakpoints_.empty(); }
  int hits(int breakpoint) const;  // so far, by id; 0 of one that is not there

  // The newest frame's stop, by the first breakpoint of the list that stops there; all are counted.
  std::optional<Stop> judge(const FrameView& view);

 private:
  std::vector<ArmedBreakpoint> breakpoints_;
  std::vector<int> hits_;  // of each
  int frames_before_ = 0;
};

}  // namespace talus
