// Edges of floors that are too low to be meant.
#pragma once

#include <talus/collision/shape.h>

namespace talus {

// px, the height of the highest edge that is a lip; higher ones are meant as walls or steps.
inline double highest_lip(TileSize tile) { return tile.height / 4.0; }

}  // namespace talus
