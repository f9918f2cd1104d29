// The switches of the overlays, in groups.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Draws the sets of overlays and the groups one after another on the current line. The overlay under the
// mouse is shown as long as it is there: see CanvasesView::hovered_overlay.
void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
