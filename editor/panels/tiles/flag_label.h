// Names of flags on the screen.
#pragma once

#include <string>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// The row of the flag's role; null if it has no role.
const FlagRoleInfo* role_of_flag(const FlagRoles& roles, int flag);

// The user's name for the flag, else its role, else empty.
std::string flag_name(const Level& level, int flag);

// How many flags are shown, from flag 0 on: those of a cart, and as many more, by 8, as the level uses.
int shown_flags(const Level& level);

// "flag 2  up-slope".
std::string flag_label(const Level& level, int flag);

// The user's name for it, else "flags 2-3".
std::string field_name(const FlagField& field);
// The user's name for the value, else the number.
std::string value_name(const FlagField& field, int value);

// What can be tinted, painted and looked for, sorted by flag: each shown flag outside of fields, and each
// value of fields.
std::vector<FlagPattern> flag_patterns(const Level& level);
// "flag 2  up-slope", "slope kind: up".
std::string pattern_label(const Level& level, FlagPattern pattern);

}  // namespace talus
