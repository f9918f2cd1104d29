// Native levels (see native.h) as JSON documents, for companions, which are parts of such documents.
#pragma once

#include "../text/json_text.h"

namespace talus {

// All members of a level as they are written; an error says what no reader would take.
FormatResult<Json> native_document(const Level& level);
FormatResult<Level> level_of_document(Json document, const Progress& progress = {});
// The text of a document or of a part of one; the error is about bytes that are no UTF-8.
FormatResult<std::string> print_document(const Json& document);

}  // namespace talus
