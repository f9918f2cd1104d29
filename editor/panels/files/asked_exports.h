// The list of files that exports would write and that the user has not allowed yet.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Fills the rest of the window, but leaves `below` px.
void draw_asked_exports(const FinishedRun& asked, float below, Ui& ui);

}  // namespace talus
