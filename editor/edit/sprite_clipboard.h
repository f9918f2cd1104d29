// Tiles, pixels and palettes as text for the clipboard. The texts of square tiles and of palettes are
// TIC-80's own, so they go from one program to the other and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "sprite_area.h"

namespace talus {

// TIC-80's text for a square of tiles: a hex digit for each pixel, row by row over all of them, and two
// digits for each tile's flags, the low one first. TIC-80 has no text for other rectangles; theirs begins
// with a line "tiles 3x2", which only Talus reads.
std::string tiles_to_text(const Level& level, const SpriteArea& area);
// Returns the pixels and flags in a text, which must have as many tiles as the area. The error is a sentence.
tl::expected<Edit, std::string> paste_tiles(const Level& level, const SpriteArea& area,
                                            std::string_view text);

// A line "pixels 5x3", and a hex digit for each pixel, row by row.
std::string pixels_to_text(const PixelBlock& block);
// Returns nothing if the text is not of this kind.
std::optional<PixelBlock> pixels_from_text(std::string_view text);

// TIC-80's text for a palette: RRGGBB for each colour.
std::string palette_to_text(const Palette& palette);
// Changes the sixteen colours of a text, or, for a single RRGGBB, only that colour. White space is ignored.
tl::expected<Edit, std::string> paste_palette(const Level& level, int color, std::string_view text);

}  // namespace talus
