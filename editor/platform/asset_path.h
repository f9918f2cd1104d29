// Where the files that come with the program are.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// The path of an asset such as "demo.talus.json": beside the installed program (../share/talus/assets), else
// in the source tree that the program was built from. The file need not exist.
std::string asset_path(std::string_view name);

}  // namespace talus
