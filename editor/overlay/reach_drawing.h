// Where a player gets to, as boxes and lines in level pixels.
#pragma once

#include "overlay.h"
#include "sim/reach.h"

namespace talus {

// Adds the cells that were reached, tinted, and a line under those in which the player stood. stale: the
// level is another by now; the cells are outlined alone. columns, rows: size of the map.
void add_reach(const ReachSearch& reach, bool stale, int columns, int rows, Rect visible,
               OverlayDrawing& drawing);

}  // namespace talus
