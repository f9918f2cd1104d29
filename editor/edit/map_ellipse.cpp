// Fills and outlines ellipses.
#include "map_ellipse.h"

#include <algorithm>
#include <vector>

#include "raster.h"

namespace talus {

Edit fill_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  for (const Span& span : ellipse_spans(cells.w, cells.h)) {
    for (int x = span.first; x <= span.last; ++x)
      painter.paint({cells.x + x, cells.y + span.y}, repeated_tile(stamp, {0, 0}, {x, span.y}));
  }
  return painter.finish("Fill ellipse");
}

Edit outline_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  const std::vector<Span> spans = ellipse_spans(cells.w, cells.h);
  for (const Span& span : spans) {
    const bool is_end = span.y == 0 || span.y == cells.h - 1;
    const Span& above = is_end ? span : spans[static_cast<std::size_t>(span.y) - 1];
    const Span& below = is_end ? span : spans[static_cast<std::size_t>(span.y) + 1];
    const int inner_first = std::max({span.first + 1, above.first, below.first});
    const int inner_last = std::min({span.last - 1, above.last, below.last});
    for (int x = span.first; x <= span.last; ++x) {
      const bool is_inner = !is_end && x >= inner_first && x <= inner_last;
      if (!is_inner)
        painter.paint({cells.x + x, cells.y + span.y}, repeated_tile(stamp, {0, 0}, {x, span.y}));
    }
  }
  return painter.finish("Outline ellipse");
}

}  // namespace talus
