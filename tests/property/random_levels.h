// Random levels for the property tests of proofs: every kind of ground that a level can have, side by side.
#pragma once

#include <talus/level/level.h>
#include "random_ground.h"

namespace talus {

// Floors, steps, tunnels and scattered tiles: full, one-way, slopes, profiles, polygons, ceilings, curves and
// a second layer, in tiles of 8x8, 16x16, 24x24 or 18x12 px; and bodies of all kinds.
Level random_level(Dice& dice);

}  // namespace talus
