// The condition in the field for a new breakpoint, which the keys that run to a breakpoint take, too.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// Whether a text is a correct condition.
bool is_condition(const std::string& text);
// Adds a breakpoint with this condition for the chosen body, unless there is an equal one.
void add_breakpoint(const std::string& condition, const Session& session, Actions& actions);

}  // namespace talus
