// Stamp: a rectangle of tiles to paint with, taken from the sheet or picked from the map.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/level/level.h>
#include <talus/level/tile_turns.h>
#include "level/cell_rect.h"

namespace talus {

struct Stamp {
  int w = 1, h = 1;
  std::vector<MapCell> tiles = {MapCell()};  // w*h, row by row
  MapCell at(int x, int y) const { return tiles[static_cast<std::size_t>(y) * w + x]; }
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

// The rectangle of the tile sheet as a stamp, cut off at the sheet's edge; tile 0 if it is wholly outside.
// Places behind the sheet's last tile have tile 0.
Stamp stamp_of_sheet(const SheetLayout& sheet, CellRect tiles);
// The same, where the first place of the sheet has another tile among others; alone it has tile 0, which
// makes cells empty. first: see displaced_tile().
Stamp stamp_of_tiles(const SheetLayout& sheet, CellRect tiles, TileNumber first);
Stamp stamp_of_map(const Level& level, CellRect cells);  // for the picker; cut off at the map's edge

// Stamps are repeated from `origin` in all directions. Returns the top-left cell of the stamp that a cell
// belongs to, and what the cell gets from it.
Cell corner_of_repeated(const Stamp& stamp, Cell origin, Cell cell);
MapCell repeated_tile(const Stamp& stamp, Cell origin, Cell cell);

// The stamp turned as a whole: its cells change places, and are turned. Tile 0 is not turned.
Stamp turned(const Stamp& stamp, TileTurn turn);

}  // namespace talus
