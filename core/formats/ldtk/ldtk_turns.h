// Tiles of LDtk that are mirrored, as turned cells of a level.
#pragma once

#include "ldtk_tiles.h"

namespace talus {

// Gives the cells that show a single mirrored tile in its place, and nothing else, that tile with a turn, if
// its shape is turned with it and its flags are the same. Tiles that are in no cell any more go. known: how
// many of the first tiles keep their numbers and what they stand for.
void turn_mirrored_tiles(const LdtkProject& project, const LdtkMapping& mapping, std::size_t known,
                         LdtkTiles& tiles);

}  // namespace talus
