// Layers of objects and of pictures in a native level (see native.h).
#pragma once

#include <string>
#include <vector>

#include <talus/level/object_layer.h>
#include "../text/json_text.h"
#include "native_pictures.h"

namespace talus {

// Reads a list; the unknown keys of each layer go into its `extra`. Objects have no others. pictures: those
// of the level.
FormatResult<std::vector<ObjectLayer>> take_object_layers(Json& list, const std::string& path,
                                                          const NativePictures& pictures);
FormatResult<Json> json_of(const std::vector<ObjectLayer>& layers, const std::string& path,
                           const NativePictures& pictures);

// Whether layers have what came with version 6: pictures, hidden objects, other anchors.
bool has_new_objects(const std::vector<ObjectLayer>& layers);

}  // namespace talus
