// GIF, in which tilesets of Tiled may be. It is only read. stb reads it, too, but takes unbounded time for a
// hostile one.
#pragma once

#include <string_view>

#include "png_picture.h"

namespace talus {

bool is_gif(std::string_view bytes);

// The size that a GIF claims; 0x0 px if it ends before it says so.
TileSize size_of_gif(std::string_view bytes);

// The first frame. What it does not cover is transparent, and so are pixels that its data lack. A picture of
// more than most_side px a side or kMaxSheetPicturePixels in all is an error.
FormatResult<RgbaPicture> read_gif(std::string_view bytes, int most_side);

}  // namespace talus
