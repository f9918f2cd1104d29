// The choice of the flag to tint, paint and look for.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// name: of the widget; its entries are "NAME0" and so on, by flag_patterns(). preview: the text shown now.
// width: px of the screen.
void draw_flag_choice(const std::string& name, const std::string& preview, float width,
                      const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
