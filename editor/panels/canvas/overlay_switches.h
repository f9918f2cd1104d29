// The switches of the overlays, which are their legend too where their names have room.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// One after another on the current line, with their names where there is room for all of them.
void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui);

// Whether their names have room. Decided by the window's width alone, so that the legend, which has them
// otherwise, and the switches agree.
bool overlay_names_fit(const Ui& ui);

}  // namespace talus
