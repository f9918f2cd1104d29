// What users of Tiled wrote into properties, as the JSON object that levels keep.
#pragma once

#include <string>

#include "tiled_edits.h"

namespace talus {

// An object with the value of each property; empty if there are none.
std::string json_of_properties(const TiledProperties& properties);

// The counterpart: the members of an object. Lists and objects become text. json: may be empty.
TiledProperties properties_of_json(const std::string& json);

// Sets the value of the property with that name. It becomes the last one.
void put_property(TiledProperties& properties, TiledProperty property);

// Whether two such objects differ at most in members that are true or false: as properties of tiles these
// would be read as flags.
bool have_same_values(const std::string& a, const std::string& b);

// What makes the members of one object those of another one. Either may be empty.
std::vector<TiledPropertyEdit> property_edits(const std::string& before, const std::string& now);

}  // namespace talus
