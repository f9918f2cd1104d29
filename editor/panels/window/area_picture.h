// Pictures of a part of a level, in its own pixels.
#pragma once

#include <memory>

#include <talus/level/level.h>
#include <talus/sim/state.h>

namespace talus {

// The cells that an area touches, px of the level.
Rect area_of_cells(const Rect& area, const TileMap& map);
// What is drawn in an area of whole cells, without bodies. Null if it cannot be drawn.
std::shared_ptr<const SheetPicture> picture_of_area(const Level& level, const Rect& area);
// The same around what of a level is shown first, in whole cells: at most so many px a side, or one cell.
std::shared_ptr<const SheetPicture> picture_of_start(const Level& level, const State& state, int most_width,
                                                     int most_height);

}  // namespace talus
