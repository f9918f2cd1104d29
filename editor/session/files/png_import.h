// Taking a picture into a sheet or the palette, with what it would change told beforehand.
#pragma once

#include <string>

#include "edit/edit.h"
#include "formats/pictures/png_sheet.h"

namespace talus {

// What becomes of a picture that is no whole number of tiles of 8x8 px, or goes over the sheet's edge.
enum class PngFit {
  exact,    // it is refused
  fill_up,  // its last tiles are filled up with colour 0; over the edge it is refused
  cut_off   // the whole tiles that there is room for are taken; of a smaller picture there are none
};

int in_whole_tiles(int side);  // px, filled up to whole tiles

struct PngImportOptions {
  PngPart part = PngPart::tiles;
  int tile = 0;                // 0..255, of the sheet, where the picture's top-left corner goes
  bool take_palette = false;   // the picture's colours become the level's; else it is drawn in the level's
  PngFit fit = PngFit::exact;  // of no meaning for a palette
  friend bool operator==(const PngImportOptions&, const PngImportOptions&) = default;
};

struct PngImportPlan {
  Edit edit;                       // empty when nothing changes
  int pixels = 0;                  // that change, of the sheet
  int tiles = 0;                   // that they are in
  int colors = 0;                  // that change, of the palette
  int tiles_recolored = 0;         // images of both sheets that look different as a color of theirs changes
  int width = 0, height = 0;       // px: what goes on the sheet, filled up or cut off; of a palette 0
  int approximated = 0;            // pixels that take another colour than their own, the nearest
  double largest_distance = 0;     // see MatchedPicture
  Cell farthest;                   // px of the picture
  Rgb farthest_from, farthest_to;  // that pixel's own colour, and what it becomes
  Sheet sheet;                     // that the picture goes on, afterwards; of a palette: the tiles
  Palette palette;                 // afterwards
};

// The error is one clear sentence: a size that is no whole number of tiles, a place where the picture does
// not fit, too many colours, no whole tile to take.
tl::expected<PngImportPlan, std::string> plan_png_import(const Level& level, const PngPicture& picture,
                                                         const PngImportOptions& options);

// A picture that was opened to be taken into the level, until the user applies or cancels it.
struct PngImport {
  std::string path;
  PngPicture picture;
  PngImportOptions options;
  tl::expected<PngImportPlan, std::string> plan;  // with these options, or why not
};

}  // namespace talus
