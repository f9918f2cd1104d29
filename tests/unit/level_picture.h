// Small levels written as pictures, for tests.
#pragma once

#include <initializer_list>
#include <string_view>

#include <talus/level/level.h>

namespace talus {

// '#' solid, 'o' ball, '/' the flagged tile of an up-slope, '\' of a down-slope, '-' a slope's second half,
// everything else empty. The tiles have the article's flags, the level has the article solver, and the map
// has the size of the picture.
inline Level level_of(std::initializer_list<std::string_view> rows) {
  Level level;
  level.tuning.solver = SolverKind::article;
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[1] = 1;  // solid
  flags[2] = 2;  // ball
  flags[3] = 4;  // up-slope
  flags[5] = 8;  // down-slope
  for (const int drawn : {1, 2, 3, 4, 5}) level.sheet(SheetId::tiles).images[drawn].fill(12);
  level.map = TileMap(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
  Cell cell{0, 0};
  for (const std::string_view row : rows) {
    cell.x = 0;
    for (const char c : row) {
      const int tile = c == '#' ? 1 : c == 'o' ? 2 : c == '/' ? 3 : c == '-' ? 4 : c == '\\' ? 5 : 0;
      level.map.set(cell, static_cast<TileNumber>(tile));
      ++cell.x;
    }
    ++cell.y;
  }
  return level;
}

}  // namespace talus
