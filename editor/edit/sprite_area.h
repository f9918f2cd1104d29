// A square of images on a sheet, seen as one canvas of pixels, and blocks of its pixels.
#pragma once

#include "level/edit.h"
#include "pixel_block.h"

namespace talus {

// 1, 2, 4 or 8 tiles wide and high.
struct SpriteArea {
  SheetId sheet = SheetId::tiles;
  CellRect tiles;  // in tiles of the sheet (16x16); must lie inside it (asserted)
  int width() const { return tiles.w * kCartTileSize; }                                    // px
  int height() const { return tiles.h * kCartTileSize; }                                   // px
  int tile_at(int x, int y) const { return (tiles.y + y) * kSheetColumns + tiles.x + x; }  // by tile
  CellRect canvas() const { return {0, 0, width(), height()}; }                            // px
  bool contains(Cell pixel) const;
  bool lies_in_sheet() const;
  friend bool operator==(const SpriteArea&, const SpriteArea&) = default;
};

std::uint8_t pixel_at(const Level& level, const SpriteArea& area, int x, int y);

// Reads a rectangle of the canvas in px, inside of it (asserted), as a block; and puts a block with its top
// left corner at `at`, without what lies outside of the canvas.
PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect);
Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label);

}  // namespace talus
