// The switches of the overlays, which are their legend too.
#pragma once

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

// One after another on the current line, with their names where there is room for all of them.
void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui);

// The names of what is shown, in the canvas's corner, while the switches have no room for them.
void draw_overlay_legend(ImDrawList& list, const Choices& choices, const CanvasView& view, const Ui& ui);

}  // namespace talus
