// A short text beside a point of the shape editor's canvas.
#pragma once

#include <string_view>

#include "panels/canvas/camera.h"
#include "panels/ui/ui.h"

namespace talus {

// Above the point, or below it at the canvas's top; not beyond the canvas's sides. away: px of the screen.
void draw_canvas_note(ImDrawList& list, std::string_view text, ImVec2 point, float away,
                      const CanvasView& view);

}  // namespace talus
