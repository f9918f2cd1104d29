// Levels of several layers, as the lint sees them.
#pragma once

#include "../ground_names.h"

namespace talus {

// ground_level() of a level, with the name and the offset of its first layer of tiles that has ground and is
// drawn elsewhere. names: as of ground_level().
Level linted_level(const Level& level, GroundNames* names = nullptr);

}  // namespace talus
