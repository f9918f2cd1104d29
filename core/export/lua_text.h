// Lua's way of writing values.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// In quotes; what is not printable ASCII, and quotes and backslashes, as \ddd. Any Lua reads the same bytes.
std::string lua_string(std::string_view text);

}  // namespace talus
