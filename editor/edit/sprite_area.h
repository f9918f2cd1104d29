// A square of images on a sheet, seen as one canvas of pixels, and blocks of its pixels.
#pragma once

#include "level/edit.h"
#include "pixel_block.h"

namespace talus {

// A rectangle of any size.
struct SpriteArea {
  SheetId sheet = SheetId::tiles;
  CellRect tiles;  // in columns and rows of the sheet, each of them an image (asserted)
  int width() const { return tiles.w * kCartTileSize; }   // px
  int height() const { return tiles.h * kCartTileSize; }  // px
  // The number of an image. x, y: columns and rows from the corner.
  int tile_at(const Level& level, int x, int y) const {
    return level.sheet(sheet).layout().tile_at({tiles.x + x, tiles.y + y});
  }
  CellRect canvas() const { return {0, 0, width(), height()}; }  // px
  bool contains(Cell pixel) const;
  bool lies_in_sheet(const Level& level) const;
  friend bool operator==(const SpriteArea&, const SpriteArea&) = default;
};

// The part of an area that lies in its sheet; the sheet's first image if none does.
SpriteArea cut_to_sheet(const Level& level, SpriteArea area);

std::uint8_t pixel_at(const Level& level, const SpriteArea& area, int x, int y);

// Reads a rectangle of the canvas in px, inside of it (asserted), as a block; and puts a block with its top
// left corner at `at`, without what lies outside of the canvas.
PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect);
Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label);

}  // namespace talus
