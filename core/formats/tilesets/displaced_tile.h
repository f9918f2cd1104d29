// The tile that the empty one displaces from its place on the sheet.
#pragma once

#include <talus/level/level.h>

namespace talus {

// Tile 0 stands for empty cells. Where the first tile of a map's first tileset is drawn, it has another
// number, and the first place of the sheet shows nothing. Returns its number; 0: it has its own, or the level
// did not come from Tiled.
TileNumber displaced_tile(const Level& level);

}  // namespace talus
