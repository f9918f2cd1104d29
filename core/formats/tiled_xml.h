// Maps and tilesets of Tiled in XML, TMX and TSX, put into the JSON that means the same, so that one reader
// serves both.
#pragma once

#include "json_text.h"

namespace talus {

// Every object has the line of its element (kTiledLineKey). Errors are placed by line.
FormatResult<Json> tiled_json_of_xml(std::string_view text);

}  // namespace talus
