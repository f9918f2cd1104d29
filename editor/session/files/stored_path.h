// Paths in the files of the state folder, which are JSON.
#pragma once

#include <string>

#include "formats/text/json_text.h"

namespace talus {

// Puts a path under a key; one that is not UTF-8 under the key with "_base64" behind it.
void put_path(Json& line, const std::string& key, const std::string& path);
// Returns such a path; an empty text if there is none. line: an object.
std::string path_in(const Json& line, const std::string& key);

}  // namespace talus
