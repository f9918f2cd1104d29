// Finding tiles on the map.
#pragma once

#include <cstddef>

#include "cell_painter.h"

namespace talus {

std::size_t count_tile(const TileMap& map, std::uint8_t tile, Within within = {});

enum class FindDirection { next, previous };
// The next cell with the tile after `from`, or before it, row by row and around the end of the map; `from`
// itself comes last. from: a cell of the map, or nothing: from the beginning or the end. Nothing: there is
// no such cell.
std::optional<Cell> find_tile(const TileMap& map, std::uint8_t tile, std::optional<Cell> from,
                              FindDirection direction, Within within = {});

}  // namespace talus
