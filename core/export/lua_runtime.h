// The Lua runtime with what a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// How Lua is written: laid out and with its comments, or in as few bytes as can be, as a cart is short of
// them.
enum class LuaForm { readable, small };

// The core of the runtime with the level's parts, those that are asked for, and, with_mouse, the one by which
// bodies can be dragged. An error when a part is not known or cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, LuaForm form, bool with_mouse);

// Joins texts into one, without their comments and what spaces Lua does not need, but for the comment at the
// head. No string in them has a quote, or two hyphens.
std::string join_lua(const std::vector<std::string>& texts);

// Of a level that was played by another solver: that games move by the exact one, as in Exported::dropped.
std::vector<std::string> dropped_solver(const Level& level);

}  // namespace talus
