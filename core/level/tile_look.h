// TileLook: what a tile looks like, apart from any sheet.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

struct TileLook {
  TileImage image = {};                 // in 16 colours
  std::vector<std::uint8_t> rgba = {};  // of a sheet in true colour, as SheetPicture::rgba; else empty
  friend bool operator==(const TileLook&, const TileLook&) = default;
};

// size: px, of the map's tiles, which a sheet in true colour shows. tile: of the sheet (not checked).
TileLook look_of(const Sheet& sheet, TileSize size, int tile);
// Gives a tile this look, which must be in true colour if the sheet is (asserted). A picture that others
// hold, too, is copied first; otherwise the call takes time by the size of the tile alone.
void put_look(const TileLook& look, TileSize size, int tile, Sheet& sheet);

// The image in 16 colours that stands for pixels in true colour: what is less than half opaque has colour 0,
// and the rest the nearest colour of the palette. rgba: of a tile of that size, which must not be empty.
TileImage image_of(const std::vector<std::uint8_t>& rgba, TileSize size, const Palette& palette);

// The colour with the smallest squared distance in RGB, 0..15; of several, the first.
std::uint8_t nearest_color(Rgb color, const Palette& palette);

}  // namespace talus
