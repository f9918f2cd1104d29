// Which layers of tiles of a level are those of the map that it came from.
#pragma once

#include <vector>

#include <talus/level/level.h>

namespace talus {

// Whether both have the same names in the same order.
bool has_same_names(const std::vector<TileLayer>& a, const std::vector<TileLayer>& b);

// By layer of the level, that of the opened one; -1: it is new. Name and cells together count most, then
// cells, then the name, then cells half of which are equal.
std::vector<int> pairs_of_tile_layers(const Level& opened, const Level& level);

}  // namespace talus
