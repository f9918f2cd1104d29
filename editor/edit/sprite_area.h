// A square of images on a sheet, seen as one canvas of pixels, and blocks of its pixels.
#pragma once

#include <talus/collision/function_ref.h>
#include "level/edit.h"
#include "pixel_block.h"

namespace talus {

// A rectangle of any size.
struct SpriteArea {
  SheetId sheet = SheetId::tiles;
  CellRect tiles;  // in columns and rows of the sheet, each of them an image (asserted)
  TileSize tile = {kCartTileSize, kCartTileSize};       // px, of an image: see painted_size()
  int width() const { return tiles.w * tile.width; }    // px
  int height() const { return tiles.h * tile.height; }  // px
  // The number of an image. x, y: columns and rows from the corner.
  int tile_at(const Level& level, int x, int y) const {
    return level.sheet(sheet).layout().tile_at({tiles.x + x, tiles.y + y});
  }
  CellRect canvas() const { return {0, 0, width(), height()}; }  // px
  bool contains(Cell pixel) const;
  bool lies_in_sheet(const Level& level) const;
  friend bool operator==(const SpriteArea&, const SpriteArea&) = default;
};

// Whether the images of a sheet are painted in true colour, and not in 16 colours.
bool is_in_rgba(const Level& level, SheetId sheet);
// The size of an image in which it is painted, px: that of the map's tiles in true colour, else 8x8.
TileSize painted_size(const Level& level, SheetId sheet);
// The part of an area that lies in its sheet, the sheet's first image if none does, with the size that its
// images have now.
SpriteArea cut_to_sheet(const Level& level, SpriteArea area);

PixelColor pixel_at(const Level& level, const SpriteArea& area, int x, int y);

// Reads a rectangle of the canvas in px, inside of it (asserted), as a block; and puts a block with its top
// left corner at `at`, without what lies outside of the canvas. The block must have the colours of the
// sheet's kind (asserted).
PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect);
Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label);

// A block with the colours of another kind of sheet: the nearest of the palette, or those that it stands for.
// Colour 0 and what is less than half opaque stand for each other.
PixelBlock in_colors_of(const Level& level, SheetId sheet, const PixelBlock& block);

// Calls use(pixel, color) for each pixel of the canvas that an edit paints.
void for_each_painted(const Level& level, const SpriteArea& area, const Edit& edit,
                      FunctionRef<void(Cell, PixelColor)> use);

}  // namespace talus
