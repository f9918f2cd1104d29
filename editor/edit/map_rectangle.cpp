// Fills and outlines rectangles.
#include "map_rectangle.h"

#include <algorithm>

namespace talus {

Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  if (const auto part = shared(cells, {0, 0, level.map.width(), level.map.height()})) {
    for (int y = part->y; y < part->y + part->h; ++y) {
      for (int x = part->x; x < part->x + part->w; ++x)
        painter.paint({x, y}, repeated_tile(stamp, {cells.x, cells.y}, {x, y}));
    }
  }
  return painter.finish("Fill rectangle");
}

Edit outline_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  const int right = cells.x + cells.w - 1, bottom = cells.y + cells.h - 1;
  for (int y = cells.y; y <= bottom; ++y) {
    const int step = y == cells.y || y == bottom ? 1 : std::max(1, cells.w - 1);
    for (int x = cells.x; x <= right; x += step)
      painter.paint({x, y}, repeated_tile(stamp, {cells.x, cells.y}, {x, y}));
  }
  return painter.finish("Outline rectangle");
}

Edit erase_cells(const Level& level, CellRect cells) {
  Edit edit = fill_rect(level, cells, {});
  edit.label = "Erase tiles";
  return edit;
}

}  // namespace talus
