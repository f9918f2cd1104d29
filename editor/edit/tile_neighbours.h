// TileNeighbours: what stands around tiles on the map, to draw them so that they join.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

// The cells around a rectangle of the tile sheet: a ring one cell wide.
struct TileNeighbours {
  int w = 1, h = 1;                               // tiles, of the rectangle within
  std::vector<std::optional<std::uint8_t>> ring;  // (w + 2) * (h + 2), row by row; none: nothing is known
  const std::optional<std::uint8_t>& at(int x, int y) const {  // -1..w, -1..h
    return ring[static_cast<std::size_t>(y + 1) * (w + 2) + x + 1];
  }
  friend bool operator==(const TileNeighbours&, const TileNeighbours&) = default;
};

// Where the rectangle of tiles stands on the map, if `cell` is part of such a place: its top left cell.
std::optional<Cell> place_of_tiles(const TileMap& map, CellRect tiles, Cell cell);
// Those of a place on the map; none beyond its edge.
TileNeighbours neighbours_at(const TileMap& map, CellRect tiles, Cell place);
// Of each tile at the rectangle's edge the commonest neighbour on that side, over the whole map; of equally
// common ones, that with the lowest number. Corners go by the corner tile. Cells of one and the same tile
// next to each other count, too: such tiles join themselves.
TileNeighbours commonest_neighbours(const TileMap& map, CellRect tiles);

}  // namespace talus
