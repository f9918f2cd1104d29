// Sheets and palettes as pictures, and the colours of a picture as those of a level.
#pragma once

#include "png_picture.h"

namespace talus {

// The part of a level that a picture shows.
enum class PngPart { tiles, sprites, palette };

// Opaque RGB: a sheet of 128x128 px, or the palette, 16x1 px.
std::string write_png_part(const Level& level, PngPart part);

// The sheet of tiles for maps of other programs: its picture in true colour, or opaque RGB: 16x16 images of
// the size of the map's tiles. Of tiles of another size than 8x8 px the pixels are repeated or left out.
std::string write_map_tiles(const Level& level);

// The same of either sheet for games, RGBA: without a picture colour 0 is transparent, as on bodies, but
// keeps its RGB values.
std::string write_clear_sheet(const Level& level, SheetId sheet);

// A picture in 16 colours.
struct MatchedPicture {
  std::vector<std::uint8_t> indices;  // 0..15 for each pixel, as in PngPicture; 0 for transparent ones
  int approximated = 0;               // number of pixels whose colour is not in the palette
  double largest_distance = 0;        // between a pixel and its new colour, in RGB: 0..442
  Cell farthest;                      // px: the first pixel with that distance
};

// Each pixel gets the colour of the palette with the smallest squared distance in RGB; of several, the first.
MatchedPicture match_colors(const PngPicture& picture, const Palette& palette);

// Returns `palette` changed so that it has the picture's colours. If the file has a palette of up to 16
// colours, it replaces the colours from index 0. Otherwise each new colour replaces the next colour that the
// picture does not use. A picture with more than 16 colours is an error.
FormatResult<Palette> palette_for(const PngPicture& picture, const Palette& palette);

// Reads a picture of a palette: its 1 to 16 pixels side by side replace the colours from index 0.
FormatResult<Palette> palette_in(const PngPicture& picture, const Palette& palette);

}  // namespace talus
