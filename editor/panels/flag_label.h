// What a flag is called on the screen.
#pragma once

#include <string>

#include "level/level.h"

namespace talus {

// The row of the role that the flag stands for; null when it has none.
const FlagRoleInfo* role_of_flag(const FlagRoles& roles, int flag);

// The user's name for it, else its role, else nothing.
std::string flag_name(const Level& level, int flag);

// "flag 2  up-slope".
std::string flag_label(const Level& level, int flag);

}  // namespace talus
