// The presets of exports in a native level, optional:
//   "exports": [{"name": "game", "to": "love", "path": "export/love", "parts": "pairs", "on_save": true}]
#pragma once

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

// An error has its place by key.
FormatResult<std::vector<ExportPreset>> take_exports(Json& list);
// An empty list gives an empty list.
FormatResult<Json> json_of(const std::vector<ExportPreset>& exports);

}  // namespace talus
