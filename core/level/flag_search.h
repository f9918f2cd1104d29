// Where a level's tiles have some flags.
#pragma once

#include <array>

#include <talus/level/level.h>

namespace talus {

// The tiles whose flags match a pattern, and how often the map shows them.
struct FlagUse {
  std::vector<int> tiles;                       // numbers of tiles of the sheet, in order
  std::array<std::size_t, kTileCount> cells{};  // of the map, by tile; 0 of tiles that do not match
  std::size_t cell_count = 0;                   // their sum
};
FlagUse find_flag_use(const Level& level, FlagPattern pattern);

// The next cell of the map, row by row, whose tile matches, or the one before; around the map's end, so that
// it is `from` itself when it is the only one. Nothing when there is none. Without `from`: the first or the
// last one. tile: 0..255 looks for that tile alone; -1: for all that match.
std::optional<Cell> find_flagged_cell(const Level& level, FlagPattern pattern, std::optional<Cell> from,
                                      bool forwards, int tile = -1);

}  // namespace talus
