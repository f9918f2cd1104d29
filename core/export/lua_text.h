// Lua's way of writing values.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// In quotes; what is not printable ASCII, and quotes and backslashes, as \ddd. Any Lua reads the same bytes.
std::string lua_string(std::string_view text);

// Lists of more tables are written as `join{function() return {...} end, ...}`, with so many in each
// function: LuaJIT takes no more than 65536 constants, of which each table of numbers is one, in a function.
inline constexpr std::size_t kMostLuaEntries = 4096;
inline constexpr std::string_view kLuaJoin =  // before what uses it
    "local function join(parts)\n"
    " local all={}\n"
    " for _,part in ipairs(parts) do for _,entry in ipairs(part()) do all[#all+1]=entry end end\n"
    " return all\n"
    "end\n";

}  // namespace talus
