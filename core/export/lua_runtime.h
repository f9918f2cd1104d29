// The Lua runtime, with the parts that a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// How Lua is written: formatted and with its comments, or in as few bytes as possible, as space in a cart is
// short.
enum class LuaForm { readable, small };

// The core of the runtime, the level's parts, those asked for, events and data in the readable form, and,
// with_mouse, the part that drags bodies.
// Returns an error if a part is not known or cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, LuaForm form, bool with_mouse);

// Joins texts into one without comments and unneeded spaces; the comment at the head stays. Their strings
// must not hold quotes or two hyphens.
std::string join_lua(const std::vector<std::string>& texts);

// Says, as in Exported::dropped, what moves otherwise in games: all bodies of a level with another solver
// than exact.
std::vector<std::string> dropped_physics(const Level& level);

}  // namespace talus
