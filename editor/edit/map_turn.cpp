#include "map_turn.h"

#include <algorithm>

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

Edit turn_cells(const Level& level, CellRect cells, TileTurn turn) {
  const TileMap& map = level.map;
  const std::string label = has_flip(turn, TileTurn::diagonal) ? "Turn tiles" : "Flip tiles";
  const auto part = shared(cells, {0, 0, map.width(), map.height()});
  if (!part) return {label, {}};
  const Stamp tiles = turned(stamp_of_map(level, *part), turn);
  if (tiles.w > map.width() || tiles.h > map.height()) return {label, {}};
  const CellRect to{std::min(part->x, map.width() - tiles.w), std::min(part->y, map.height() - tiles.h),
                    tiles.w, tiles.h};
  CellPainter painter(map);
  for (int y = 0; y < to.h; ++y)
    for (int x = 0; x < to.w; ++x) painter.paint({to.x + x, to.y + y}, tiles.at(x, y));
  for (int y = part->y; y < part->y + part->h; ++y)
    for (int x = part->x; x < part->x + part->w; ++x)
      if (!to.contains({x, y})) painter.paint({x, y}, {});
  Edit edit = painter.finish(label);
  if (!(to == cells)) edit.selection = SelectionChange{cells, to, SelectionChange::Tiles::stays};
  return edit;
}

}  // namespace talus
