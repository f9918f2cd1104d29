// Values in the syntax of Lua.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// In quotes. Bytes that are not printable ASCII, quotes and backslashes become \ddd. Every Lua reads the same
// bytes.
std::string lua_string(std::string_view text);

// Whether a name or a number of Lua may have the character: an ASCII letter or digit, or _.
bool is_lua_word(char c);

// Whether a text can be a key without quotes: a name, and no word of Lua's own.
bool is_lua_name(std::string_view text);

// A list of more tables is written as `join{function() return {...} end, ...}`, with this many in each
// function. LuaJIT allows 65536 constants in a function, and each table of numbers is one.
inline constexpr std::size_t kMaxLuaEntries = 4096;
inline constexpr std::string_view kLuaJoin =  // goes before the code that uses it
    "local function join(parts)\n"
    " local all={}\n"
    " for _,part in ipairs(parts) do for _,entry in ipairs(part()) do all[#all+1]=entry end end\n"
    " return all\n"
    "end\n";

}  // namespace talus
