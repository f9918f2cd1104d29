// JPEG, in which tilesets of Tiled may be. It is only read.
#pragma once

#include <string_view>

#include "png_picture.h"

namespace talus {

bool is_jpeg(std::string_view bytes);

// The size that a JPEG claims; 0x0 px if its header is damaged.
TileSize size_of_jpeg(std::string_view bytes);

// Where the pixels of a JPEG are damaged, the picture has what its reader made of them. Bytes without a
// JPEG's header, one of more than 100 scans, and a size that check_picture_size() refuses are an error.
FormatResult<RgbaPicture> read_jpeg(std::string_view bytes, int most_side);

}  // namespace talus
