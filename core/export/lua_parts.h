// The parts of Lua's runtime: which of them a level uses, and the files in assets/runtime that they are in.
// Parts hang themselves into tables of the core, so that any set of them makes a module.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

// "slopes, one_way, segments, curves, balls, players, pairs, mouse": what can be asked for.
std::string lua_part_names();

// The parts that the exact solver needs for the level, and those named in `more` with commas between, with
// the parts that they rest on; in the order in which they are joined. An error names a word that is no part.
FormatResult<std::vector<std::string>> lua_parts(const Level& level, std::string_view more = {});

// The names of the files of a module of these parts and the core, without folder and ".lua", in order.
std::vector<std::string> lua_part_files(const std::vector<std::string>& parts);

}  // namespace talus
