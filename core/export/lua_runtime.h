// The Lua runtime, with the parts that a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// How Lua is written: formatted and with its comments, or in as few bytes as possible, as space in a cart is
// short.
enum class LuaForm { readable, small };

// The core of the runtime, the level's parts, those asked for, and events, steer and data, as one module to
// read. plays: the game is there, too, with the part that drags bodies, and pairs, as its rules may add
// bodies. Returns an error if a part is not known or cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, bool plays);

// The texts of the files of some parts, see lua_part_files(), for TIC-80, which runs Lua 5.3.
FormatResult<std::vector<std::string>> cart_runtime(const ExportRequest& request,
                                                    const std::vector<std::string>& parts);

// Joins texts into one without comments and unneeded spaces; the comment at the head stays. Their strings
// must not hold quotes or two hyphens.
std::string join_lua(const std::vector<std::string>& texts);

// Joins texts into one to read, in less space: a level of blocks is indented by one space instead of two, and
// of each comment that fills lines the first sentence, or the title, is there, in one line.
std::string brief_lua(const std::vector<std::string>& texts);

// Says, as in Exported::dropped, what moves otherwise in games: all bodies of a level with another solver
// than exact.
std::vector<std::string> dropped_physics(const Level& level);

}  // namespace talus
