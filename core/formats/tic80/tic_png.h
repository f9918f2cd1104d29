// TIC-80 cartridges inside PNG pictures, read alone.
//
// The cart, `.tic`, is packed by zlib and stands in a chunk `caRt`; or, in older pictures, in the low bits of
// the pixels: their bytes (red, green, blue, opacity, from the top left) hold four bits each of a header of
// four bytes, how many bits each of the bytes behind it holds (1 to 8), and the size of what they hold in
// three bytes, low bits first as all here. The layout is TIC-80's (src/ext/png.c).
#pragma once

#include <talus/formats/format.h>

namespace talus {

// Whether it is a PNG picture at all, so that the error about one without a cart can say what to do with it.
bool accepts_tic_png(std::string_view bytes, const FormatContext& context);
// Whether there is a cart in it, be it a damaged one; else it is a picture, or no PNG.
bool has_tic_cart(std::string_view png);
// As read_tic; the level's origin is the cart without its picture.
FormatResult<Level> read_tic_png(std::string_view bytes, const FormatContext& context);

}  // namespace talus
