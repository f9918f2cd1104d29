// The picture behind a level of LDtk, as a layer of a level.
#pragma once

#include <optional>

#include <talus/level/object_layer.h>
#include "../import/import_drops.h"
#include "ldtk_project.h"

namespace talus {

// A layer of a picture, or of an object with one if it is scaled, behind all others. origin: px, of the map
// in the level of LDtk. Nothing without a picture, and for one that is too large.
std::optional<ObjectLayer> ldtk_background_layer(const LdtkBackground& background, Vec2 origin,
                                                 ImportDrops& drops);
// Whether a layer is that one.
bool is_ldtk_background(const ObjectLayer& layer);

}  // namespace talus
