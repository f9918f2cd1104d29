// What an edit does with the recording, as a choice beside the timeline.
#pragma once

#include "session/session.h"
#include "ui.h"

namespace talus {

inline constexpr float kEditRuleWidth = 158;  // px at scale 1

void draw_edit_rule_choice(const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
