// Shorter names for the local variables and inner methods of Lua code, as space in a cart is short.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace talus {

// What of the code nothing outside of it reads.
struct InnerNames {
  std::span<const std::string_view> tables = {};  // names that are methods of these alone
  std::span<const std::string_view> fields = {};  // of its tables; not a name of anything else
};

// Gives each local name of the code a short one, the same everywhere; methods name their `self` as a
// parameter for that. Other fields, keys of tables, and names that Lua itself has, stay. The code must be a
// whole chunk without comments and long strings, whose globals are those of Lua alone.
std::string with_short_names(const std::string& lua, const InnerNames& inner = {});

}  // namespace talus
