// Replaces tiles.
#include "map_replace.h"

namespace talus {

Edit replace_tile(const Level& level, TileNumber tile, Cell origin, const Stamp& stamp, Within within) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  const CellRect all{0, 0, map.width(), map.height()};
  if (const auto part = shared(within.value_or(all), all)) {
    for (int y = part->y; y < part->y + part->h; ++y) {
      for (int x = part->x; x < part->x + part->w; ++x) {
        if (map.at({x, y}) == tile) painter.paint({x, y}, repeated_tile(stamp, origin, {x, y}));
      }
    }
  }
  return painter.finish("Replace tiles");
}

}  // namespace talus
