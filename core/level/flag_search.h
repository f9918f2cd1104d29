// Finds the tiles of a level that have certain flags.
#pragma once

#include <vector>

#include <talus/level/level.h>

namespace talus {

// The layers of tiles that a search looks at.
enum class SearchedLayers { all, chosen };

// The tiles whose flags match a pattern, and their number on the map.
struct FlagUse {
  std::vector<int> tiles;          // numbers of tiles of the sheet, in order
  std::vector<std::size_t> cells;  // number on the map, by tile; 0 for tiles that do not match
  std::size_t cell_count = 0;      // their sum
};
FlagUse find_flag_use(const Level& level, FlagPattern pattern, SearchedLayers layers = SearchedLayers::all);

// Returns the next cell of the map, row by row, in which a tile of these layers matches, or the previous one.
// In layers in front of others tile 0 is no tile. The search goes on
// around the map's end, and returns `from` itself if no other cell matches; nothing if no cell does. Without
// `from` it returns the first or the last one. tile: 0 and above looks only for that tile; -1: for all that
// match.
std::optional<Cell> find_flagged_cell(const Level& level, FlagPattern pattern, std::optional<Cell> from,
                                      bool forwards, int tile = -1,
                                      SearchedLayers layers = SearchedLayers::all);

}  // namespace talus
