// The selected cells on a canvas.
#pragma once

#include "camera.h"
#include "level/cell_rect.h"
#include "panels/ui/ui.h"

namespace talus {

// The cells of the selection in dashes, dark and bright, so that they show on any art.
void draw_selection(ImDrawList& list, const CellRect& cells, const CanvasView& view, const Ui& ui);

}  // namespace talus
