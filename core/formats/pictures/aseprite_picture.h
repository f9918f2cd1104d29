// Pictures of Aseprite, `.aseprite` and `.ase`, in which tilesets of LDtk and Tiled may be. They are only
// read.
#pragma once

#include "png_picture.h"

namespace talus {

inline constexpr std::size_t kMaxCelPixels = std::size_t{1} << 26;  // of all cels of a picture together

bool is_aseprite(std::string_view bytes);

// The size that a picture of Aseprite claims; 0x0 px if the bytes are none.
TileSize size_of_aseprite(std::string_view bytes);

// The first frame: its visible layers over one another, whatever modes they blend by. Layers of tilemaps are
// an error, as is a picture of more than most_side px a side or kMaxSheetPicturePixels in all.
FormatResult<RgbaPicture> read_aseprite(std::string_view bytes, int most_side);

}  // namespace talus
