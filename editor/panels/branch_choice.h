// The branches of the timeline: which is shown, which is compared with it, and what is still to be run.
#pragma once

#include "session/session.h"
#include "ui.h"

namespace talus {

inline constexpr float kBranchWidth = 150;  // px at scale 1, of each of its two controls

void draw_branch_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
