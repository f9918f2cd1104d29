// A plot of a series over the frames of a branch.
#pragma once

#include "debug/plot_series.h"
#include "frame_axis.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Fills the rectangle. at: the frame of the cursor line.
void draw_plot(ImDrawList& list, const Series& series, const FrameAxis& axis, ImVec2 min, ImVec2 max,
               std::int64_t at, ImU32 color, const Ui& ui);

// Draws it over the whole timeline, from here to the right edge; the mouse on it shows another frame. Leaves
// the cursor below it. series: null draws an empty plot.
void draw_timeline_plot(const std::string& name, std::string_view help, const Series* series, ImU32 color,
                        float height, const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
