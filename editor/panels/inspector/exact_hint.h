// What works only with the exact solver, in a level that has another one.
#pragma once

#include <string>
#include <string_view>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// A sentence, "Curves stop bodies only with the exact solver.", and a button that chooses it; nothing if the
// level has it. widget: name of the button.
void draw_exact_hint(std::string_view sentence, const std::string& widget, const Session& session,
                     Actions& actions, Ui& ui);

}  // namespace talus
