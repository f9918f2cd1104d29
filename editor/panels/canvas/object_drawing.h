// How objects of a level look on a canvas.
#pragma once

#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

// The outlines of the objects in layers that are shown; those of ground are brighter. mouse: px of the
// screen; the object below it has its name beside it.
void draw_objects(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui, ImVec2 mouse);

}  // namespace talus
