// Shorter names for the local variables and inner methods of Lua code, as space in a cart is short.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace talus {

// Gives each local name of the code a short one, the same everywhere; methods name their `self` as a
// parameter for that. Fields, keys of tables, and names that Lua itself has, stay. The code must be a whole
// chunk without comments and long strings, whose globals are those of Lua alone. inner: tables of the code
// that nothing outside of it reads; names that are methods of these alone become short, too.
std::string with_short_names(const std::string& lua, std::initializer_list<std::string_view> inner = {});

}  // namespace talus
