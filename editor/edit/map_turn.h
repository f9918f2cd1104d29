// Turns the selected cells of the map as a whole.
#pragma once

#include <talus/level/tile_turns.h>
#include "level/edit.h"

namespace talus {

// Turns the tiles of the cells where they are, and selects the cells that have them then. After a quarter
// turn these keep the top left corner, if there is room on the map; cells that are left have tile 0. The edit
// is empty if the turned tiles have no room on the map.
Edit turn_cells(const Level& level, CellRect cells, TileTurn turn);

}  // namespace talus
