// Stamp: a rectangle of tiles to paint with, taken from the sheet or picked from the map.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

struct Stamp {
  int w = 1, h = 1;
  std::vector<std::uint8_t> tiles = {0};  // w*h, row by row
  std::uint8_t at(int x, int y) const { return tiles[static_cast<std::size_t>(y) * w + x]; }
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

// The rectangle of the tile sheet (16 columns) as a stamp; cut at the sheet's edge. Wholly outside: tile 0.
Stamp stamp_of_sheet(CellRect tiles);
Stamp stamp_of_map(const Level& level, CellRect cells);  // the picker; cut likewise at the map's edge

// The top-left cell of the stamp that a cell belongs to, where stamps are repeated from `origin` in all
// directions, and the tile that the cell has of it.
Cell corner_of_repeated(const Stamp& stamp, Cell origin, Cell cell);
std::uint8_t repeated_tile(const Stamp& stamp, Cell origin, Cell cell);

}  // namespace talus
