// Plain data as text: JSON or a Lua table, both by one printer.
//
// docs/export-data.md describes the members of the object that the exporters `json` and `lua` write.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include <talus/formats/format.h>
#include <talus/level/level.h>
#include <talus/level/progress.h>
#include "plain_data.h"

namespace talus {

using OrderedJson = nlohmann::ordered_json;  // keeps the order of its members

// One shape and one body of the object.
OrderedJson plain_shape_json(const PlainShape& shape);
OrderedJson plain_body_json(const PlainBody& body);

enum class Dialect { json, lua };

// One line for each member of the object, and for each entry of a list of lists or objects. Lua has `return`
// before it, and, if lists are too long for LuaJIT, a function that joins their parts. Errors are those of
// ground_polygons(). level: with its ground in one layer of tiles. whole: as ExportRequest::whole().
FormatResult<std::string> plain_text(const Level& level, const Level& whole, Dialect dialect,
                                     const Progress& progress = {});

}  // namespace talus
