// The Lua runtime with what a level uses, as one text.
#pragma once

#include "exporter.h"

namespace talus {

// with_mouse: balls can be dragged. An error when a part cannot be read.
FormatResult<std::string> lua_runtime(const ExportRequest& request, bool with_mouse);

}  // namespace talus
