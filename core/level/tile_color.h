// The colours of tiles, whatever says how they look.
#pragma once

#include <cstdint>
#include <span>

#include <talus/level/level.h>

namespace talus {

// The pixel of a side of so many px, from 0, that stands for pixel i, 0..7, of an image of 8x8.
constexpr int pixel_of_side(int i, int side) { return (2 * i + 1) * side / (2 * kCartTileSize); }

// The colour, 0..15, of an image at a pixel of a tile of that size, which it fills.
std::uint8_t color_at(const TileImage& image, TileSize tile, int x, int y);

// The commonest of the colours, 0..15, of some pixels; of equally common ones the lowest.
std::uint8_t main_color(std::span<const std::uint8_t> pixels);

// Whether a picture of tiles of that size shows nothing of a tile.
bool is_clear(const SheetPicture& picture, const SheetLayout& layout, TileNumber tile, TileSize size);
// Whether nothing is seen of a tile of the level, or of a sprite: in true colour, if its sheet has it.
bool is_blank(const Level& level, TileNumber tile, SheetId sheet = SheetId::tiles);
// Which pixels of a tile's image of 8x8 are drawn, row by row, from the lowest bit: those that are at least
// half opaque in true colour, if its sheet has it, else those that are not colour 0.
std::uint64_t drawn_pixels(const Level& level, TileNumber tile);

// Lays a colour over a pixel of four bytes, red, green, blue and opacity: Porter and Duff's "over".
void lay_over(std::uint8_t* under, Rgba over);

// The colour of a pixel of a tile, as the map shows it: what is not opaque lies over colour 0. x, y: px of
// the map from the corner of the cell.
Rgb color_on_map(const Level& level, TileNumber tile, int x, int y);

}  // namespace talus
