// Ellipses of tiles on the map. Cells outside the map, or outside `within`, are left out.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// The ellipse that touches the rectangle's sides (see ellipse_spans), or its outline one cell wide, filled
// with the stamp, repeated from the rectangle's top-left corner.
Edit fill_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
Edit outline_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});

}  // namespace talus
