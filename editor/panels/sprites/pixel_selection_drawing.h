// The selected pixels on the pixel canvas.
#pragma once

#include "level/cell_rect.h"
#include "panels/canvas/camera.h"

namespace talus {

// rect: px of the canvas. scale: of the window.
void draw_pixel_selection(ImDrawList& list, CellRect rect, const CanvasView& view, float scale);

}  // namespace talus
