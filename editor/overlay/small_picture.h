// A small picture of a whole level, for lists of levels.
#pragma once

#include <talus/level/level.h>

namespace talus {

// The visible layers over one another, over its background, with at most so many pixels a side
// (at least 1): each is a block of cells, or a cell. A map that is far longer than wide may be one pixel
// wide.
SheetPicture small_picture(const Level& level, int most_width, int most_height);

}  // namespace talus
