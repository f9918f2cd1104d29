// A plot of a series over the frames of a run.
#pragma once

#include "debug/watch.h"
#include "frame_axis.h"
#include "ui.h"

namespace talus {

// Fills the rectangle. at: the frame under the cursor's line.
void draw_plot(ImDrawList& list, const Series& series, const FrameAxis& axis, ImVec2 min, ImVec2 max,
               std::int64_t at, ImU32 color, const Ui& ui);

}  // namespace talus
