// Tiles of the map as text, as TIC-80's map editor puts it on the clipboard.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "edit/stamp.h"

namespace talus {

// TIC-80's form has one byte each for width, height and every tile, row by row. A byte is two hexadecimal
// digits, the low one first. TIC-80 has no text for sides of more than 255 cells. For these the text begins
// with a line "map 300x20" instead of the first two bytes, which only Talus reads. It begins with "wide map
// 300x20", and has two bytes for each tile, the low one first, if one has a number over 255; with "turned map
// 300x20" it has a third byte, the bits of its turn, if one is turned.
std::string text_of_cells(const Stamp& tiles);
// The tiles of such a text; white space is skipped. The error is the end of a sentence: "the clipboard is
// empty".
tl::expected<Stamp, std::string> cells_of_text(std::string_view text);

}  // namespace talus
