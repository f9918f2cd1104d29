// How a picture of tiles is cut: how many tiles come out, and a guess of their size.
#pragma once

#include <string>

#include <talus/level/tileset.h>
#include "../pictures/png_picture.h"

namespace talus {

// The tiles that come out of a picture.
struct CutGrid {
  int columns = 0, rows = 0;   // of whole tiles
  int rest_x = 0, rest_y = 0;  // px at the right and at the bottom that belong to no tile, margin included
  int count() const { return columns * rows; }
};
// width, height: px, of the picture. No tiles come out if the sides of a tile or the spacing are out of
// range.
CutGrid grid_of(const TileCut& cut, int width, int height);

// Why a picture of that size cannot be cut so, as a sentence; empty if it can.
std::string problem_of(const TileCut& cut, int width, int height);

// The size of the tiles and the gaps between them that the picture most likely has. Gaps are found where
// they have one colour or are clear, and the tiles fill the rest. wanted: tried before the usual sizes.
TileCut guess_cut(const RgbaPicture& picture, TileSize wanted = {16, 16});

// Whether nothing is drawn in a tile. place: column and row in the cut.
bool is_clear_tile(const RgbaPicture& picture, const TileCut& cut, Cell place);

}  // namespace talus
