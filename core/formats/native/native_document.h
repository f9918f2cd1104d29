// Native levels (see native.h) as JSON documents. Companions are parts of such documents.
#pragma once

#include "../text/json_text.h"

namespace talus {

// All members of a level as they are written. The error says what no reader would accept.
FormatResult<Json> native_document(const Level& level);
// The same for a file in a folder, where linked tilesets are links. dropped: gets a phrase for each link that
// cannot be stored.
FormatResult<Json> native_document(const Level& level, const std::string& folder,
                                   std::vector<std::string>& dropped);
FormatResult<Level> level_of_document(Json document, const Progress& progress = {});
// The text of a document or of a part of it. Bytes that are not UTF-8 are an error.
FormatResult<std::string> print_document(const Json& document);

}  // namespace talus
