// Other numbers for the tiles of a level.
#pragma once

#include <vector>

#include <talus/level/level.h>

namespace talus {

// Gives the sheet of tiles another layout, and its tiles other numbers, wherever the level names them.
// numbers: by tile, its new number, each once; -1: it goes, and what shows it gets tile 0. Tilesets go: the
// caller knows their places.
void renumber_tiles(Level& level, const SheetLayout& layout, const std::vector<int>& numbers);

}  // namespace talus
