// Says what a hard case does besides the user.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// For a hard case with input of its own: what it holds in the next step, and what the user's keys change.
// For one without input that is edited: that only its checks do that. Empty for other levels.
std::string case_note(const Session& session);

}  // namespace talus
