// The choice of the flag that is tinted, painted and looked for.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// name: of the widget; those of its list are "NAME0" and so on, by flag_patterns(). preview: what it shows
// now. width: px of the screen.
void draw_flag_choice(const std::string& name, const std::string& preview, float width,
                      const Session& session, Actions& actions, Ui& ui);

}  // namespace talus
