// Tools of the map: each makes an Edit from a level and a gesture, and changes nothing itself. Cells outside
// the map are left out.
#pragma once

#include <vector>

#include "edit.h"

namespace talus {

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

// The cells that a tool may paint, such as the selection; nothing: all of the map.
using Within = std::optional<CellRect>;

// One stamp with its top-left cell at `at`.
Edit paint_stamp(const Level& level, Cell at, const Stamp& stamp);
// Stamps along the straight line between two cells, both included, aligned to `anchor` in steps of the
// stamp's size, so that a drag tiles it.
Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp,
                  Within within = {});
// The rectangle, or its outline one cell wide, filled with the stamp, repeated from its top-left corner.
Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
Edit outline_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
// The same for the ellipse that touches the rectangle's sides (see ellipse_spans).
Edit fill_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
Edit outline_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within = {});
// The 4-connected area of equal tiles around a cell, filled with the stamp repeated from there. `within`
// bounds the area too.
Edit flood_fill(const Level& level, Cell at, const Stamp& stamp, Within within = {});
// Every cell with the tile, filled with the stamp repeated from `origin`.
Edit replace_tile(const Level& level, std::uint8_t tile, Cell origin, const Stamp& stamp, Within within = {});
Edit erase_cells(const Level& level, CellRect cells);

}  // namespace talus
