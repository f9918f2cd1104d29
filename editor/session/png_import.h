// Taking a picture into a sheet or the palette, with what it would change told beforehand.
#pragma once

#include <string>

#include "edit/edit.h"
#include "formats/png_sheet.h"

namespace talus {

struct PngImportOptions {
  PngPart part = PngPart::tiles;
  int tile = 0;               // 0..255, of the sheet, where the picture's top-left corner goes
  bool take_palette = false;  // the picture's colours become the level's; else it is drawn in the level's
  friend bool operator==(const PngImportOptions&, const PngImportOptions&) = default;
};

struct PngImportPlan {
  Edit edit;                    // empty when nothing changes
  int pixels = 0;               // that change, of the sheet
  int tiles = 0;                // that they are in
  int colors = 0;               // that change, of the palette
  int tiles_recolored = 0;      // images of both sheets that look different as a color of theirs changes
  double largest_distance = 0;  // see MatchedPicture
  Cell farthest;                // px of the picture
  Sheet sheet;                  // that the picture goes on, afterwards; of a palette: the tiles
  Palette palette;              // afterwards
};

// The error is one clear sentence: a size that is no whole number of tiles, a place where the picture does
// not fit, too many colours.
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
