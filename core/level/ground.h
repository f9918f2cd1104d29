// The ground of a level, compiled for collision.
#pragma once

#include "../collision/terrain.h"
#include "level.h"

namespace talus {

// What the terrain of a level is made of. Refers to the level's map, which must stay while it is used. Shapes
// and curves that cannot be used are left out; lint tells of them.
TerrainSource ground_of(const Level& level);

}  // namespace talus
