// What the window shows of the debugger beside its panels.
#pragma once

#include <optional>

#include <talus/collision/geometry.h>

namespace talus {

// Which of the recorded frames the timeline and the plots show.
struct FrameZoom {
  double first = 0;  // frame at the left edge, 0 or more
  double count = 0;  // frames that have room; 0: all of them
  friend bool operator==(const FrameZoom&, const FrameZoom&) = default;
};

struct DebuggerView {
  FrameZoom frames;
  bool legend_folded = false;        // the overlays' legend has no names
  bool follow_body = false;          // the play view scrolls with the chosen body
  bool picks_cell = false;           // the next click on a canvas chooses a cell for a breakpoint
  std::optional<Cell> picked_cell;   // that was chosen so; taken by the panel
  std::optional<Cell> clicked_cell;  // of the map, with the left button, last
};

}  // namespace talus
