// Pictures of every kind that a map may name.
#pragma once

#include <string_view>

#include "png_picture.h"

namespace talus {

// The size that a PNG, JPEG, BMP, GIF, TGA or picture of Aseprite claims; 0x0 px if the bytes are none. A
// side of a PNG above kMaxSheetPicturePixels is 0.
TileSize size_of_picture(std::string_view bytes);

// Returns the pixels of such a picture; of an animated one the first frame. most_side: as in read_rgba().
FormatResult<RgbaPicture> read_picture(std::string_view bytes, int most_side = kMaxPngSide);

}  // namespace talus
