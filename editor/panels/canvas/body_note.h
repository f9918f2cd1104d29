// What the play view says at the body that the user looks at.
#pragma once

#include <string>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Which keys play if the user moves the body in a pause, or that it has left the map. Empty: nothing. holds:
// whether the mouse holds it.
std::string body_note(const Body& body, bool holds, const Session& session, const Ui& ui);

}  // namespace talus
