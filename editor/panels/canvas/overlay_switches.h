// The switches of the overlays, which are also their legend if their names have room.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Draws them one after another on the current line, with their names if there is room for all of them.
void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui);

// Whether their names have room. Depends only on the window's width, so that the switches and the legend,
// which has the names otherwise, agree.
bool overlay_names_fit(const Ui& ui);

}  // namespace talus
