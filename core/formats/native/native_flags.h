// Flags, their names and their fields in a native level (see native.h).
#pragma once

#include "../text/json_text.h"

namespace talus {

// Errors of all have their place by key under `path`.
FormatResult<FlagSet> take_flags(const Json& list, const std::string& path);
Json json_of_flags(FlagSet flags);
FormatResult<std::array<std::string, kMaxFlags>> take_flag_names(const Json& list, const std::string& path);
// As many names as carts have flags, and those of the flags after them up to the last one with a name.
Json json_of(const std::array<std::string, kMaxFlags>& names);
// Whether a level uses flags that a cart does not have, which came with version 6.
bool has_more_flags(const Level& level);

// Errors have their place by key: "key flag_fields[1].bits". Unknown keys of a field are kept in
// its `extra`. Fields that were read can be used: no two share a flag, and problem_of() finds nothing wrong.
FormatResult<std::vector<FlagField>> take_flag_fields(const Json& list, const std::string& path);
// Fields that take_flag_fields would refuse are an error.
FormatResult<Json> json_of(const std::vector<FlagField>& fields, const std::string& path);

}  // namespace talus
