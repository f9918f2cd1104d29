// Ground for maps that have none yet.
#pragma once

#include "level/edit.h"

namespace talus {

// Whether the map shows tiles, and nothing of the level is ground: no tile, curve or object.
bool lacks_ground(const Level& level);

// Makes the tiles that the chosen layer shows full ground, apart from those with a shape or that stand for a
// body, and the layer a layer of ground. Other layers that show such a tile become scenery, unless they hold
// bodies. Empty if there is no such tile.
Edit make_tiles_ground(const Level& level);

}  // namespace talus
