// The JSON that Tiled wrote before version 1.2, which has objects where there are lists now.
#pragma once

#include "../text/json_text.h"

namespace talus {

// Gives a map, a tileset or a template the form of today. Properties become a list, and the tiles of a
// tileset, with their properties, too. Does nothing to what has that form, and leaves wrong values to the
// reader.
void modernise_tiled_json(Json& json);

}  // namespace talus
