// The Lua runtime, with the parts that a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// How Lua is written: formatted and with its comments, or in as few bytes as possible, as space in a cart is
// short.
enum class LuaForm { readable, small };

// The core of the runtime, the level's parts, those asked for, and, in the readable form, events, steer and
// data. plays: the game is there, too; it has the part that drags bodies, and in the readable form also
// pairs, as its rules may add bodies. Returns an error if a part is not known or cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, LuaForm form, bool plays);

// Joins texts into one without comments and unneeded spaces; the comment at the head stays. Their strings
// must not hold quotes or two hyphens.
std::string join_lua(const std::vector<std::string>& texts);

// Says, as in Exported::dropped, what moves otherwise in games: all bodies of a level with another solver
// than exact.
std::vector<std::string> dropped_physics(const Level& level);

}  // namespace talus
