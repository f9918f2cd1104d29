// The list of what exports would write that the user has not allowed yet.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Fills what is left of the window but `below` px.
void draw_asked_exports(const FinishedRun& asked, float below, Ui& ui);

}  // namespace talus
