// Parts of the Lua runtime: which of them a level uses, and which files of assets/runtime they are in. Parts
// add themselves to tables of the core, so any set of parts makes a module.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

// The parts that may be asked for: "slopes, one_way, segments, curves, balls, players, pairs, mouse".
std::string lua_part_names();

// Returns the parts that the exact solver needs for the level, those named in `more` (separated by commas),
// and the parts that they need; in the order in which they are joined. The error names an unknown part.
FormatResult<std::vector<std::string>> lua_parts(const Level& level, std::string_view more = {});

// Names of the files of a module with these parts and the core, without folder and ".lua", in order.
std::vector<std::string> lua_part_files(const std::vector<std::string>& parts);

}  // namespace talus
