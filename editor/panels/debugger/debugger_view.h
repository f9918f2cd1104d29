// What the window shows of the debugger besides its panels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace talus {

// The recorded frames that the timeline and the plots show.
struct FrameZoom {
  double first = 0;  // frame at the left edge, 0 or more
  double count = 0;  // number of frames; 0: all
  friend bool operator==(const FrameZoom&, const FrameZoom&) = default;
};

struct DebuggerView {
  FrameZoom frames;
  int stage = -1;                           // of the chosen body's step, drawn in the play view; -1: no stage
  int pointed_stage = -1;                   // the one under the mouse in Why, drawn instead
  int pointed_in = -2;                      // the number of the window's frame in which it was
  int input_row = 0;                        // of the input roll, that its keys change
  std::optional<std::int64_t> input_range;  // where the range of its keys began; it ends at the shown frame
  bool shows_times = false;                 // the time of each step is plotted
  std::string new_condition;                // in the field for a new breakpoint, not entered yet
  bool picks_cell = false;                  // the next click on a canvas chooses a cell for a breakpoint
  bool why_has_chosen = false;              // Why has chosen the player, as no body was chosen

  // The stage to draw in a frame of the window; -1: none. Panels may be drawn after the canvas.
  int shown_stage(int frame) const { return frame - pointed_in <= 1 ? pointed_stage : stage; }

  void forget_level() {  // another level is open
    frames = {};
    picks_cell = why_has_chosen = false;
  }
};

}  // namespace talus
