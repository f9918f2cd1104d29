// Maps and tilesets of Tiled, `.tmx`, `.tmj`, `.tsx` and `.tsj`, which are read alone. A tileset without a
// map becomes a level with an empty one.
//
// Tilesets and pictures in files of their own are looked for in the folder of the file that names them, by
// relative paths; without a folder tilesets are an error, and pictures are left out. core/export writes maps.
#pragma once

#include "format.h"

namespace talus {

bool accepts_tiled_json(std::string_view bytes, const FormatContext& context);
bool accepts_tiled_xml(std::string_view bytes, const FormatContext& context);
// Of either form, by content.
FormatResult<Level> read_tiled(std::string_view bytes, const FormatContext& context);

}  // namespace talus
