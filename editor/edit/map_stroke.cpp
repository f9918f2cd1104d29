// Paints stamps along a line.
#include "map_stroke.h"

#include "raster.h"

namespace talus {
namespace {

void paint_one(CellPainter& painter, Cell at, const Stamp& stamp) {
  for (int y = 0; y < stamp.h; ++y) {
    for (int x = 0; x < stamp.w; ++x) painter.paint({at.x + x, at.y + y}, stamp.at(x, y));
  }
}

}  // namespace

Edit paint_stamp(const Level& level, Cell at, const Stamp& stamp) {
  CellPainter painter(level.map);
  paint_one(painter, at, stamp);
  return painter.finish("Paint tiles");
}

Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  std::optional<Cell> last;
  for_each_on_line(from, to, [&](Cell cell) {
    const Cell at = corner_of_repeated(stamp, anchor, cell);
    if (last != at) paint_one(painter, at, stamp);
    last = at;
  });
  return painter.finish("Paint tiles");
}

}  // namespace talus
