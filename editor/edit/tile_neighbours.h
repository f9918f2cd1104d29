// TileNeighbours: the tiles around some tiles on the map, for drawing tiles that join.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

// The cells around a rectangle of the tile sheet: a ring one cell wide.
struct TileNeighbours {
  int w = 1, h = 1;  // tiles, of the rectangle within
  // (w + 2) * (h + 2), row by row; nothing: the neighbour is not known.
  std::vector<std::optional<TileNumber>> ring;
  const std::optional<TileNumber>& at(int x, int y) const {  // -1..w, -1..h
    return ring[static_cast<std::size_t>(y + 1) * (w + 2) + x + 1];
  }
  friend bool operator==(const TileNeighbours&, const TileNeighbours&) = default;
};

// If `cell` is part of a place on the map with this rectangle of the tile sheet, returns the top left cell of
// the place; else nothing.
std::optional<Cell> place_of_tiles(const Level& level, CellRect tiles, Cell cell);
// The neighbours of a place on the map; nothing beyond its edge.
TileNeighbours neighbours_at(const TileMap& map, CellRect tiles, Cell place);
// For each tile at the rectangle's edge, the most common neighbour on that side over the whole map; of
// equally common ones, the one with the lowest number. The corner tiles decide about the corners. Equal tiles
// side by side count, too: such tiles join themselves.
TileNeighbours commonest_neighbours(const Level& level, CellRect tiles);

}  // namespace talus
