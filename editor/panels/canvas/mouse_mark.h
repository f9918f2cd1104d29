// The recorded mouse on a canvas.
#pragma once

#include "camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Marks its place in the step to the shown frame; filled while its button was down. Nothing at frame 0, or if
// it was not used.
void draw_mouse_mark(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui);

}  // namespace talus
