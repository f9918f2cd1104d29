// BMP and TGA, in which tilesets of Tiled may be. They are only read.
#pragma once

#include <string_view>

#include "png_picture.h"

namespace talus {

// The size that such a picture claims; 0x0 px if the bytes are none.
TileSize size_by_stb(std::string_view bytes);

// Bytes that are no such picture, and one of more than most_side px a side or kMaxSheetPicturePixels in all,
// are an error.
FormatResult<RgbaPicture> read_by_stb(std::string_view bytes, int most_side);

}  // namespace talus
