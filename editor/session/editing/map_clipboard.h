// Tiles of the map as the text that TIC-80's map editor has on the clipboard.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "edit/stamp.h"

namespace talus {

// TIC-80's form is one byte each for width and height and then for every tile, row by row; a byte is two
// hexadecimal digits, the low one first. TIC-80 has no text of a side longer than 255 cells; that begins with
// a line "map 300x20" instead of the first two bytes, for here alone.
std::string text_of_cells(const Stamp& tiles);
// The same back; white space is skipped. The error is the end of a sentence: "the clipboard is empty".
tl::expected<Stamp, std::string> cells_of_text(std::string_view text);

}  // namespace talus
