// Replaces a tile on the map by others.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// Fills every cell of `within` that has the tile with the stamp, repeated from `origin`. Where the tile is
// turned, what replaces it is turned as well.
Edit replace_tile(const Level& level, TileNumber tile, Cell origin, const Stamp& stamp, Within within = {});

}  // namespace talus
