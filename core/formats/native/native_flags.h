// Fields of flags in a native level (see native.h).
#pragma once

#include "../text/json_text.h"

namespace talus {

// Errors have their place by key under `path`: "key flag_fields[1].bits". Unknown keys of a field are kept in
// its `extra`. Fields that were read can be used: no two share a flag, and problem_of() finds nothing wrong.
FormatResult<std::vector<FlagField>> take_flag_fields(const Json& list, const std::string& path);
// Fields that take_flag_fields would refuse are an error.
FormatResult<Json> json_of(const std::vector<FlagField>& fields, const std::string& path);

}  // namespace talus
