// Fills areas of equal tiles on the map.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// Fills the 4-connected area of equal tiles, turned alike, around a cell with the stamp, repeated from there.
// `within` also bounds the area. Empty if the cell is outside of the map.
Edit flood_fill(const Level& level, Cell at, const Stamp& stamp, Within within = {});

}  // namespace talus
