// The branches of the timeline: the shown one, the one it is compared with, and what is still to be run.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// px at scale 1, of the choice and of the button that shows long work and ends it.
inline constexpr float kBranchWidth = 212, kProgressWidth = 140;

void draw_branch_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
