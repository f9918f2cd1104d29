// Maps written in letters, for tests of the map's tools.
#pragma once

#include <string>
#include <vector>

#include "level/edit.h"

namespace talus {

using MapRows = std::vector<std::string>;

// A level with a map of one letter a cell: '.' is tile 0, 'a' is 1, 'b' is 2.
inline Level level_of_rows(const MapRows& rows) {
  Level level;
  level.map = TileMap(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (Cell c{0, 0}; c.y < level.map.height(); ++c.y) {
    for (c.x = 0; c.x < level.map.width(); ++c.x) {
      const char letter = rows[static_cast<std::size_t>(c.y)][static_cast<std::size_t>(c.x)];
      level.map.set(c, static_cast<TileNumber>(letter == '.' ? 0 : letter - 'a' + 1));
    }
  }
  return level;
}

inline MapRows rows_of(const TileMap& map) {
  MapRows rows(static_cast<std::size_t>(map.height()));
  for (Cell c{0, 0}; c.y < map.height(); ++c.y) {
    for (c.x = 0; c.x < map.width(); ++c.x) {
      const int tile = map.tile_at(c);
      rows[static_cast<std::size_t>(c.y)] += static_cast<char>(tile == 0 ? '.' : 'a' + tile - 1);
    }
  }
  return rows;
}

inline MapRows rows_after(Level level, const Edit& edit) {
  apply_edit(level, edit);
  return rows_of(level.map);
}

}  // namespace talus
