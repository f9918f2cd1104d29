// Finds the files that come with the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

// The path of an asset such as "demo.talus.json": beside the installed program (../share/talus/assets), else
// in the source tree that the program was built from. The file need not exist.
std::string asset_path(std::string_view name);

// The paths of the demo and of other levels that show what there is, in the order in which they are offered.
std::vector<std::string> scene_paths();

// The paths of the levels in assets/hard_cases, sorted by name; empty if the folder is missing.
std::vector<std::string> hard_case_paths();

}  // namespace talus
