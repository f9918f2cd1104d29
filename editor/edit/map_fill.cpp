// Fills connected cells that look the same.
#include "map_fill.h"

#include "raster.h"

namespace talus {

Edit flood_fill(const Level& level, Cell at, const Stamp& stamp, Within within) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  if (map.contains(at)) {
    const auto same = [&, tile = map.at(at)](Cell cell) {
      return map.at(cell) == tile && (!within || within->contains(cell));
    };
    for (const Span& span : flood_area(map.width(), map.height(), at, same)) {
      for (int x = span.first; x <= span.last; ++x)
        painter.paint({x, span.y}, repeated_tile(stamp, at, {x, span.y}));
    }
  }
  return painter.finish("Fill area");
}

}  // namespace talus
