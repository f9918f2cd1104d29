// The branches of the timeline: which is shown, which is compared with it, and what is still to be run.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// px at scale 1, of the choice and of the button that shows and ends long work.
inline constexpr float kBranchWidth = 176, kProgressWidth = 140;

void draw_branch_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
