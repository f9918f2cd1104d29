// Replaces a tile of the map by another one, in all cells or in the selected ones.
#include "map_replace.h"

namespace talus {

Edit replace_tile(const Level& level, TileNumber tile, Cell origin, const Stamp& stamp, Within within) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  const CellRect all{0, 0, map.width(), map.height()};
  if (const auto part = shared(within.value_or(all), all)) {
    for (int y = part->y; y < part->y + part->h; ++y) {
      for (int x = part->x; x < part->x + part->w; ++x) {
        const MapCell before = map.at({x, y});
        if (before.tile != tile) continue;
        MapCell after = repeated_tile(stamp, origin, {x, y});
        if (after.tile != 0) after.turn = after_turn(after.turn, before.turn);
        painter.paint({x, y}, after);
      }
    }
  }
  return painter.finish("Replace tiles");
}

}  // namespace talus
