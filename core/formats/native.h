// Talus's own levels, `.talus.json`: JSON that people can read, and that diffs row by row.
//
//   "talus"       version of the file, 1. A newer version is refused. The only key that must be there.
//   "palette"     16 colours "rrggbb". Default: Sweetie 16.
//   "flag_names"  up to 8 strings, by flag; "" for a flag without a name. Default: none.
//   "roles"       which flag, 0..7 or null for none, is "solid" (0), "up_slope" (2), "down_slope" (3), "ball"
//   (1). "tuning"      "solver": "article"; and the numbers of level/tuning.h by their keys, units and
//   ranges. "spawns"      bodies placed by hand: "name" (""), "x", "y" in px (0), "vx", "vy" in px/frame (0);
//   each number
//                 within one million.
//   "tiles"       by tile number "0".."255": "flags", a list of the flags set (none), and "pixels", eight
//   rows of "sprites"     eight hexadecimal palette indices, "." for 0 (all 0). Blank tiles are left out.
//   "map"         "width" (240) and "height" (136), 1..4096 cells; "rows", from the top: two hexadecimal
//   digits a
//                 cell, ".." for tile 0, empty cells at the end of a row and rows at the end left out.
//   "cart"        what else the cart held that the level came from (see native_cart.h). Default: none.
//
// Keys that this version does not know are kept, in every object but the chunks and lines of "cart", which a
// newer version cannot extend. A value outside its range, or of another type, is an error with its place.
#pragma once

#include "format.h"

namespace talus {

inline constexpr int kNativeVersion = 1;

bool accepts_native(std::string_view bytes, const FormatContext& context);
FormatResult<Level> read_native(std::string_view bytes, const FormatContext& context);
FormatResult<WrittenLevel> write_native(const Level& level, const FormatContext& context);

}  // namespace talus
