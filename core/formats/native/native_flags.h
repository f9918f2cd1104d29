// Fields of flags in a native level (see native.h).
#pragma once

#include "../text/json_text.h"

namespace talus {

// Errors are placed by key under `path`: "key flag_fields[1].bits". The unknown keys of each field are kept
// in its `extra`. What is read can be used: no two fields share a flag, and problem_of() says nothing.
FormatResult<std::vector<FlagField>> take_flag_fields(const Json& list, const std::string& path);
// What take_flag_fields would refuse is an error.
FormatResult<Json> json_of(const std::vector<FlagField>& fields, const std::string& path);

}  // namespace talus
