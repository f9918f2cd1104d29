// Where the pixels of a level's tiles are in the pictures of the project's tilesets.
#pragma once

#include "../../level/picture_tiles.h"
#include "ldtk_tiles.h"

namespace talus {

// Tiles that show one whole tile of LDtk; others have several over one another, or none.
PictureTiles picture_tiles_of(const LdtkTiles& tiles, const LdtkPictures& pictures);

}  // namespace talus
