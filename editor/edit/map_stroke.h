// Stamps tiles on the map, once or along a stroke. Cells outside of the map, or outside of `within`, are left
// out.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// One stamp with its top-left cell at `at`.
Edit paint_stamp(const Level& level, Cell at, const Stamp& stamp);
// Stamps along the straight line between two cells, both included. The stamps are aligned to `anchor` in
// steps of the stamp's size, so that a drag makes a seamless pattern.
Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp,
                  Within within = {});

}  // namespace talus
