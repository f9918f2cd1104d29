// The mouse as it was recorded, on a canvas.
#pragma once

#include "camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Where it was in the step to the shown frame; full while its button was down. Nothing at frame 0, and
// where it has not been used.
void draw_mouse_mark(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui);

}  // namespace talus
