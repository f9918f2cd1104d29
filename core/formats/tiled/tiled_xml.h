// Converts Tiled's XML, TMX and TSX, to JSON with the same meaning, so that one reader serves both.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "../text/json_text.h"

namespace talus {

// Every object has the line of its element (kXmlLineKey). Errors have their place by line. progress:
// receives how much of the text is converted, and may stop the work, which is an error.
FormatResult<Json> tiled_json_of_xml(std::string_view text, const Progress& progress = {});

// Says which limit of tiled_json_of_xml a text exceeds: "has too many elements". Returns nothing if it keeps
// all.
std::optional<std::string> problem_of_tiled_xml(std::string_view text);

}  // namespace talus
