// Finds the tiles of a level that have certain flags.
#pragma once

#include <vector>

#include <talus/level/level.h>

namespace talus {

// The tiles whose flags match a pattern, and their number on the map.
struct FlagUse {
  std::vector<int> tiles;          // numbers of tiles of the sheet, in order
  std::vector<std::size_t> cells;  // number on the map, by tile; 0 for tiles that do not match
  std::size_t cell_count = 0;      // their sum
};
FlagUse find_flag_use(const Level& level, FlagPattern pattern);

// Returns the next cell of the map, row by row, whose tile matches, or the previous one. The search goes on
// around the map's end, and returns `from` itself if no other cell matches; nothing if no cell does. Without
// `from` it returns the first or the last one. tile: 0..255 looks only for that tile; -1: for all that match.
std::optional<Cell> find_flagged_cell(const Level& level, FlagPattern pattern, std::optional<Cell> from,
                                      bool forwards, int tile = -1);

}  // namespace talus
