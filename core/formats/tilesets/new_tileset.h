// Levels and tilesets made from a picture of tiles.
#pragma once

#include <string>

#include <talus/formats/format.h>
#include "../pictures/png_picture.h"

namespace talus {

// A PNG of tiles as it is in the file.
struct TileFile {
  RgbaPicture picture;
  std::vector<Rgb> palette;  // of the file; empty: it has none
};
FormatResult<TileFile> read_tile_picture(const std::string& path);

// A picture of tiles and how it is cut.
struct TilePicture {
  const RgbaPicture& picture;
  std::vector<Rgb> palette = {};  // of the file; empty: it has none
  TileCut cut = {};               // without a problem (see tile_cut.h)
  std::string name = {};          // of the tileset; bytes that are not UTF-8 become "\xff"
  std::string link = {};  // path of the picture, absolute, if the tileset shows it; empty: it is copied
};

// A level of that many cells with the tiles of a picture, whose size is that of its cells. A picture whose
// first tile is drawn lies below a row of blank tiles, as tile 0 is the empty one.
FormatResult<Level> level_of_tiles(const TilePicture& tiles, int width, int height);

// The level with a tileset more, below all others. If that is wider than the sheet, tiles get other numbers.
FormatResult<Level> with_tileset(Level level, const TilePicture& tiles);

// The level without a tileset and its tiles; what shows them gets tile 0. index: of Level::tilesets.
Level without_tileset(Level level, std::size_t index);

}  // namespace talus
