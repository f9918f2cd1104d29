// Plain data as text: JSON, or a table of Lua, by one printer.
//
// docs/export-data.md tells the members of the object that the exporters `json` and `lua` write.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include <talus/formats/format.h>
#include <talus/level/level.h>
#include <talus/level/progress.h>
#include "plain_data.h"

namespace talus {

using OrderedJson = nlohmann::ordered_json;  // keeps members as they were put

// One of its shapes, and one of its bodies.
OrderedJson plain_shape_json(const PlainShape& shape);
OrderedJson plain_body_json(const PlainBody& body);

enum class Dialect { json, lua };

// A member of the whole a line, and of a list of lists or objects in it an entry a line; in Lua with the
// `return` before it, and, where lists are too long for LuaJIT, with a function that joins their parts. An
// error: that of ground_polygons().
FormatResult<std::string> plain_text(const Level& level, Dialect dialect, const Progress& progress = {});

}  // namespace talus
