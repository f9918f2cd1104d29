// The choice of what an edit does with the recording, beside the timeline.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

inline constexpr float kEditRuleWidth = 158;  // px at scale 1

void draw_edit_rule_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
