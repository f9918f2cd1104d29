// Notes of tiles as JSON: by tile number, what it says.
#pragma once

#include <talus/level/tile_note.h>

#include "../text/json_text.h"

namespace talus {

FormatResult<TileNotes> take_notes(Json& json, int tile_count);
// An empty object if there are none.
FormatResult<Json> json_of(const TileNotes& notes, int tile_count);

}  // namespace talus
