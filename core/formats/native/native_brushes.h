// The brushes and the auto-tile set in a native level, both optional:
//   "brushes": [{"name": "bush", "random": true, "rows": ["0a0b", "1a1b"]}]    tiles as in the map's rows
//   "auto_tiles": {"inside": 16, "top": 1, ...}    by the names of the parts; tiles from 1 to 255
#pragma once

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

// Each function takes the members that it knows out of the JSON and leaves the others. An error has its place
// by key.
FormatResult<std::vector<Brush>> take_brushes(Json& list);
FormatResult<AutoTiles> take_auto_tiles(Json& json);

// An empty list or set gives an empty list or object.
FormatResult<Json> json_of(const std::vector<Brush>& brushes);
void put_auto_tiles(const AutoTiles& tiles, Json& json);

}  // namespace talus
