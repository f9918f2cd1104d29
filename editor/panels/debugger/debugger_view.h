// What the window shows of the debugger besides its panels.
#pragma once

#include <optional>

#include <talus/collision/geometry.h>

namespace talus {

// The recorded frames that the timeline and the plots show.
struct FrameZoom {
  double first = 0;  // frame at the left edge, 0 or more
  double count = 0;  // number of frames; 0: all
  friend bool operator==(const FrameZoom&, const FrameZoom&) = default;
};

struct DebuggerView {
  FrameZoom frames;
  bool legend_folded = false;        // the legend of the overlays has no names
  bool follow_body = false;          // the play view scrolls with the chosen body
  bool picks_cell = false;           // the next click on a canvas chooses a cell for a breakpoint
  std::optional<Cell> picked_cell;   // the cell that was chosen so; the panel takes it
  std::optional<Cell> clicked_cell;  // the last cell of the map that was clicked with the left button
};

}  // namespace talus
