// Tiles, pixels and palettes as text for the clipboard. The texts of square tiles and of palettes are
// TIC-80's own, so they go from one program to the other and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "sprite_area.h"

namespace talus {

// The tiles of a sheet; in 16 colours in TIC-80's text for a square of tiles: a hex digit for each pixel, row
// by row over all of them, and two digits for each tile's flags, the low one first. TIC-80 has no text for
// other rectangles; theirs begins with a line "tiles 3x2", which only Talus reads. So do tiles with flags
// above 7, with a line "tiles 3x2 flags": each has eight digits of flags. In true colour the line is
// "tiles 3x2 rgba 48x32", with the size in px, RRGGBBAA for each pixel, and eight digits of flags for each
// tile.
std::string tiles_to_text(const Level& level, const SpriteArea& area);
// Puts the pixels and flags of a text into an area, which must have as many tiles. The text must be of the
// colours of the sheet. The error is a sentence.
tl::expected<Edit, std::string> paste_tiles(const Level& level, const SpriteArea& area,
                                            std::string_view text);

// A line "pixels 5x3", and a hex digit for each pixel, row by row; of a block in true colour "rgba 5x3", and
// RRGGBBAA for each pixel.
std::string pixels_to_text(const PixelBlock& block);
// Returns nothing if the text is not of this kind.
std::optional<PixelBlock> pixels_from_text(std::string_view text);
// Whether a text is of tiles in true colour that have the size of an area in that.
bool has_tiles_for(const Level& level, const SpriteArea& area, std::string_view text);
// The pixels of the tiles in a text of tiles; nothing if the text is not of this kind.
std::optional<PixelBlock> tile_pixels_from_text(std::string_view text);

// TIC-80's text for a palette: RRGGBB for each colour.
std::string palette_to_text(const Palette& palette);
// Changes the sixteen colours of a text, or, for a single RRGGBB, only that colour. White space is ignored.
tl::expected<Edit, std::string> paste_palette(const Level& level, int color, std::string_view text);

}  // namespace talus
