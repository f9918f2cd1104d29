// Where the pixels of a level's tiles are in the pictures of the map's tilesets.
#pragma once

#include "../../level/picture_tiles.h"
#include "tiled_tiles.h"

namespace talus {

PictureTiles picture_tiles_of(const TiledTiles& tiles, const TiledMap& map, const TiledPictures& pictures);

}  // namespace talus
