// Tools of the map: each makes an Edit from a level and a gesture, and changes nothing itself. Cells outside
// the map are left out.
#pragma once

#include <vector>

#include "edit.h"

namespace talus {

struct CellRect {
  int x = 0, y = 0, w = 1, h = 1;  // cells; w, h >= 1
  bool contains(Cell c) const { return c.x >= x && c.y >= y && c.x < x + w && c.y < y + h; }
  friend bool operator==(const CellRect&, const CellRect&) = default;
};
CellRect spanned(Cell a, Cell b);  // the smallest rectangle with both

// A rectangle of tiles to paint with.
struct Stamp {
  int w = 1, h = 1;
  std::vector<std::uint8_t> tiles = {0};  // w*h, row by row
  std::uint8_t at(int x, int y) const { return tiles[static_cast<std::size_t>(y) * w + x]; }
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

// The rectangle of the tile sheet (16 columns) as a stamp; cut at the sheet's edge. Wholly outside: tile 0.
Stamp stamp_of_sheet(CellRect tiles);
Stamp stamp_of_map(const Level& level, CellRect cells);  // the picker; cut likewise at the map's edge

// One stamp with its top-left cell at `at`.
Edit paint_stamp(const Level& level, Cell at, const Stamp& stamp);
// Stamps along the straight line between two cells, both included, aligned to `anchor` in steps of the
// stamp's size, so that a drag tiles it.
Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp);
// The rectangle filled with the stamp, repeated from its top-left corner.
Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp);
// The 4-connected area of equal tiles around a cell, filled with the stamp repeated from there.
Edit flood_fill(const Level& level, Cell at, const Stamp& stamp);
Edit erase_cells(const Level& level, CellRect cells);

}  // namespace talus
