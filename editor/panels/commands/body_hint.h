// How to choose a body, in panels that show one.
#pragma once

#include <string>
#include <string_view>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// A sentence and buttons, for a level that has bodies. purpose: what follows "click one with the hand", as
// " to plot it", or empty. widget: prefix of the buttons' names.
void draw_body_hint(std::string_view purpose, const std::string& widget, const Session& session,
                    Actions& actions, Ui& ui);

}  // namespace talus
