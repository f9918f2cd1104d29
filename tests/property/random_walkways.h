// Random walkways: floors without a gap or an edge, for the property tests of walks: who walks must get to
// the other end.
#pragma once

#include <talus/level/level.h>
#include "random_ground.h"

namespace talus {

// A floor of level and sloped stretches from the left side of the map to the right one, of tiles, segments or
// polygon objects, with one body on it: a player 1/2 to 3.5 tiles wide, on its whole bottom or on its centre.
// Cells below a floor of tiles may be empty. A floor that only rises, or only falls, may have a ceiling just
// as high above it as the body is, of segments or of a polygon object.
Level random_walkway(Dice& dice);

}  // namespace talus
