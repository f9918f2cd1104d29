// Why the layers of a level cannot be saved into a map of Tiled.
#pragma once

#include <talus/formats/format.h>
#include <talus/level/level.h>

namespace talus {

// The first layer or group of the level that its map does not hold as it is: its name as the place, what it
// has that the map cannot hold, and what would help. held: the level that the map gives once it is written;
// its layers differ from those of `level`, and the same one is chosen.
FormatError lost_layer(const Level& held, const Level& level);

}  // namespace talus
