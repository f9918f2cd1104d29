// Zooming along the recorded frames: the timeline and all plots show the same ones.
#pragma once

#include "debugger_view.h"
#include "frame_axis.h"
#include "panels/ui/ui.h"

namespace talus {

// The shown frames out of 0..last (last >= 1), from `left` px on.
FrameAxis axis_of(const FrameZoom& zoom, std::int64_t last, float left, float width);

// steps > 0: zooms in. Keeps `frame` in its place.
void zoom_frames(FrameZoom& zoom, double frame, float steps, std::int64_t last);
void pan_frames(FrameZoom& zoom, double frames, std::int64_t last);
// Pans as little as needed to show the frame.
void show_frame(FrameZoom& zoom, std::int64_t frame, std::int64_t last);

// For ImGui's last item, which has this axis: the wheel zooms at the mouse, and the middle button drags. The
// change shows in the next frame.
void handle_frame_zoom(const FrameAxis& axis, std::int64_t last, Ui& ui);

}  // namespace talus
