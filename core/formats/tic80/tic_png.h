// TIC-80 cartridges inside of PNG pictures. They are only read, not written.
//
// The cart, `.tic`, is packed by zlib. It is in a chunk `caRt` or, in older pictures, in the low bits of the
// pixels. There the bytes of the pixels (red, green, blue, opacity, from the top left) hold four bits each of
// a header of four bytes. The header says how many bits each following byte holds (1 to 8), and how many
// bytes they make in all, in three bytes. Low bits come first everywhere. The layout is TIC-80's
// (src/ext/png.c).
#pragma once

#include <talus/formats/format.h>

namespace talus {

// Whether it is a PNG picture at all: the error for one without a cart says what to do with it.
bool accepts_tic_png(std::string_view bytes, const FormatContext& context);
// Whether there is a cart in it, maybe a damaged one.
bool has_tic_cart(std::string_view png);
// As read_tic. The level's origin is the cart without its picture.
FormatResult<Level> read_tic_png(std::string_view bytes, const FormatContext& context);

}  // namespace talus
