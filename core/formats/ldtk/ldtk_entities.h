// The entities of a level of LDtk that are no bodies, as layers of objects.
#pragma once

#include <vector>

#include "../import/import_drops.h"
#include "ldtk_tiles.h"

namespace talus {

// From the back to the front; none for layers without such entities. Fields are properties, without those
// that are null. An entity that Talus exported is the object that it was, where LDtk did not move it. ground:
// from ldtk_ground_layer(). origin: px, of the map in the level of LDtk. What is left out is added to
// `drops`.
std::vector<ObjectLayer> ldtk_object_layers(const LdtkProject& project, const LdtkLevel& level,
                                            const LdtkMapping& mapping, int ground, Vec2 origin,
                                            ImportDrops& drops);

}  // namespace talus
