// Says which input plays besides the user's keys.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// For a hard case with input of its own: what it holds in the next step, and what the user's keys change.
// Empty for other levels.
std::string case_note(const Session& session);

}  // namespace talus
