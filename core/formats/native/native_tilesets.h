// The tilesets of native levels (see native.h).
#pragma once

#include <string>
#include <vector>

#include <talus/level/tileset.h>
#include "../text/json_text.h"

namespace talus {

// layout: of the sheet with their tiles.
FormatResult<std::vector<Tileset>> take_tilesets(Json& list, const SheetLayout& layout);
FormatResult<Json> json_of(const std::vector<Tileset>& tilesets, const SheetLayout& layout);

}  // namespace talus
