// Tiles, pixels and palettes as the clipboard's text. That of a square of tiles and of a palette is TIC-80's
// own, so that they go from one program to the other and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "sprite_area.h"

namespace talus {

// TIC-80's text of a square of tiles: a hex digit for each pixel, row by row over all of them, and two for
// each tile's flags, the low one first. TIC-80 has no text of other rectangles; theirs begins with a line
// "tiles 3x2", for here alone.
std::string tiles_to_text(const Level& level, const SpriteArea& area);
// The pixels and flags of a text, which must be of as many tiles as the area; the error is a sentence.
tl::expected<Edit, std::string> paste_tiles(const Level& level, const SpriteArea& area,
                                            std::string_view text);

// A line "pixels 5x3", and a hex digit for each pixel, row by row.
std::string pixels_to_text(const PixelBlock& block);
// Nothing when the text is no such one.
std::optional<PixelBlock> pixels_from_text(std::string_view text);

// TIC-80's text of a palette: RRGGBB of each colour.
std::string palette_to_text(const Palette& palette);
// The sixteen colours of a text, or of one of a single RRGGBB that colour alone. White space counts nothing.
tl::expected<Edit, std::string> paste_palette(const Level& level, int color, std::string_view text);

}  // namespace talus
