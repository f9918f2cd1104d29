// Layers of objects in a native level (see native.h).
#pragma once

#include <string>
#include <vector>

#include <talus/level/object_layer.h>
#include "../text/json_text.h"

namespace talus {

// Reads a list; the unknown keys of each layer go into its `extra`. Objects have no others.
FormatResult<std::vector<ObjectLayer>> take_object_layers(Json& list, const std::string& path);
FormatResult<Json> json_of(const std::vector<ObjectLayer>& layers, const std::string& path);

}  // namespace talus
