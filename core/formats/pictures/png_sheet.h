// Sheets and palettes as pictures: what a level's look like, and how a picture's colours become the level's.
#pragma once

#include "png_picture.h"

namespace talus {

// What of a level a picture shows.
enum class PngPart { tiles, sprites, palette };

// Opaque RGB: a sheet of 128x128 px, or the palette, 16x1 px.
std::string write_png_part(const Level& level, PngPart part);

// The tiles for games, RGBA: colour 0 is clear, as bodies are drawn, and has its colour all the same.
std::string write_clear_tiles(const Level& level);

// A picture in 16 colours.
struct MatchedPicture {
  std::vector<std::uint8_t> indices;  // 0..15, a pixel each as in PngPicture; of transparent ones 0
  int approximated = 0;               // pixels whose own colour is not in the palette
  double largest_distance = 0;        // between a pixel and its colour, in RGB: 0..442
  Cell farthest;                      // px: the first pixel with that distance
};

// Each pixel takes the colour of the palette with the smallest squared distance in RGB, among equals the
// first.
MatchedPicture match_colors(const PngPicture& picture, const Palette& palette);

// `palette` changed so that it has the picture's colours: the palette of the file from index 0, in its order,
// or, where the file has none or a longer one, each new colour in place of the next that the picture does not
// use. An error when the picture has more than 16 colours.
FormatResult<Palette> palette_for(const PngPicture& picture, const Palette& palette);

// A picture of a palette: 1 to 16 pixels side by side replace as many colours from index 0.
FormatResult<Palette> palette_in(const PngPicture& picture, const Palette& palette);

}  // namespace talus
