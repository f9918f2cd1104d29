// Rectangles of tiles on the map. Cells outside the map, or outside `within`, are left out.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// The rectangle, or its outline one cell wide, filled with the stamp, repeated from its top-left corner.
Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
Edit outline_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
Edit erase_cells(const Level& level, CellRect cells);

}  // namespace talus
