// Makes room for a file without losing what is in its place.
#pragma once

#include <string>

#include <talus/formats/format.h>

namespace talus {

// Renames what is at `path`, whatever it is, to a free name beside it: "a.tic" to "a-kept1.tic". Returns the
// new path.
FormatResult<std::string> keep_aside(const std::string& path);

}  // namespace talus
