// Maps and tilesets of Tiled in XML, TMX and TSX, put into the JSON that means the same, so that one reader
// serves both.
#pragma once

#include "../text/json_text.h"

namespace talus {

// Every object has the line of its element (kTiledLineKey). Errors are placed by line. progress: told how
// much of the text is put into JSON; where it says so, that is an error.
FormatResult<Json> tiled_json_of_xml(std::string_view text, const Progress& progress = {});

}  // namespace talus
