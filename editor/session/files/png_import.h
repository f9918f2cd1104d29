// PngImport: a picture for a sheet or the palette, with the changes that it would make.
#pragma once

#include <string>

#include "formats/pictures/png_sheet.h"
#include "level/edit.h"

namespace talus {

// What to do with a picture that is not a whole number of tiles of 8x8 px, or goes over the sheet's edge.
enum class PngFit {
  exact,    // refuse it
  fill_up,  // fill up its last tiles with colour 0; refuse it if it goes over the edge
  cut_off   // take the whole tiles that there is room for; a smaller picture has none
};

int in_whole_tiles(int side);  // px, rounded up to whole tiles

struct PngImportOptions {
  PngPart part = PngPart::tiles;
  int tile = 0;  // 0..255, tile of the sheet at the picture's top-left corner
  bool take_palette =
      false;  // the level gets the picture's colours; else the picture is drawn in the level's
  PngFit fit = PngFit::exact;  // ignored for a palette
  friend bool operator==(const PngImportOptions&, const PngImportOptions&) = default;
};

struct PngImportPlan {
  Edit edit;                // empty if nothing changes
  int pixels = 0;           // changed pixels of the sheet
  int tiles = 0;            // tiles with changed pixels
  int colors = 0;           // changed colours of the palette
  int tiles_recolored = 0;  // images of both sheets that look different because one of their colours changes
  int width = 0, height = 0;    // px: the part that goes on the sheet, filled up or cut off; 0 for a palette
  int approximated = 0;         // pixels that get the nearest colour instead of their own
  double largest_distance = 0;  // see MatchedPicture
  Cell farthest;                // px of the picture
  Rgb farthest_from, farthest_to;  // that pixel's own colour, and its new one
  Sheet sheet;                     // the sheet of the picture afterwards; for a palette the tiles
  Palette palette;                 // afterwards
};

// The error is one sentence: a size that is not a whole number of tiles, a place where the picture does not
// fit, too many colours, or no whole tile.
tl::expected<PngImportPlan, std::string> plan_png_import(const Level& level, const PngPicture& picture,
                                                         const PngImportOptions& options);

// An opened picture, until the user imports it into the level or cancels.
struct PngImport {
  std::string path;
  PngPicture picture;
  PngImportOptions options;
  tl::expected<PngImportPlan, std::string> plan;  // the result with these options, or why there is none
};

}  // namespace talus
