// What plays besides the user's keys.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// Of a hard case that brings its own input: what it holds in the next step, and what the user's keys do to
// that. Empty without one.
std::string case_note(const Session& session);

}  // namespace talus
