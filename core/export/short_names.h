// Shorter names for the local variables of Lua code, as space in a cart is short.
#pragma once

#include <string>

namespace talus {

// Gives each local name of the code a short one, the same everywhere. Names that are also fields, or that Lua
// itself has, stay. The code must be a whole chunk without comments and long strings, whose globals are those
// of Lua alone.
std::string with_short_names(const std::string& lua);

}  // namespace talus
