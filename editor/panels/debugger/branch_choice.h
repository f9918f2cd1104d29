// The branches of the timeline: the shown one, the one it is compared with, and what is still to be run.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

void draw_branch_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
