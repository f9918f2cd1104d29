// Links in the places of files.
#pragma once

#include <string>

namespace talus {

// Returns where a link leads, as real_path() does; empty if the path is no link, or one in a circle.
std::string link_target(const std::string& path);

}  // namespace talus
