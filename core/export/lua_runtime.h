// The Lua runtime with what a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// with_mouse: balls can be dragged. An error when a part cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, bool with_mouse);

// Of a level that was played by another solver: that games move by the exact one, as in Exported::dropped.
std::vector<std::string> dropped_solver(const Level& level);

}  // namespace talus
