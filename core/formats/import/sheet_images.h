// The tiles of a level that comes from another program, in 16 colours.
#pragma once

#include <vector>

#include <talus/level/level.h>

namespace talus {

// Gives each tile of the level its image of `images`, which has 8x8 px for each, at the tiles' places. The
// level's palette gets the colours if there are few enough, but for its colour 0, which is no colour of art.
// palette: of the file with the picture; may be empty.
void put_images(const SheetPicture& images, const std::vector<Rgb>& palette, Level& level);

// Whether the tiles' images, stretched over the tiles, look as the picture does, which has an image of the
// size of the map's tiles for each.
bool images_show(const SheetPicture& picture, const Level& level);

// Whether the images have the colour 0, which stands for nothing where layers lie over one another, at an
// opaque pixel of that picture.
bool has_opaque_color_0(const SheetPicture& picture, const Level& level);

}  // namespace talus
