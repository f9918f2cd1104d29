// Filling areas of equal tiles on the map.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// The 4-connected area of equal tiles around a cell, filled with the stamp repeated from there. `within`
// bounds the area too. Empty outside the map.
Edit flood_fill(const Level& level, Cell at, const Stamp& stamp, Within within = {});

}  // namespace talus
