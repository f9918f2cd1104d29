// Finding tiles on the map.
#pragma once

#include <cstddef>

#include "cell_painter.h"

namespace talus {

// However the tile is turned.
std::size_t count_tile(const TileMap& map, TileNumber tile, Within within = {});

enum class FindDirection { next, previous };
// Returns the next cell with the tile after `from`, or before it, row by row and around the end of the map.
// `from` itself comes last. Without `from` the search starts at the beginning or the end. Returns nothing if
// no cell has the tile.
std::optional<Cell> find_tile(const TileMap& map, TileNumber tile, std::optional<Cell> from,
                              FindDirection direction, Within within = {});

}  // namespace talus
