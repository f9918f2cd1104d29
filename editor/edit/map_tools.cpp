// The tools of the map.
#include "map_tools.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "cell_painter.h"
#include "raster.h"

namespace talus {
namespace {

void paint_one(CellPainter& painter, Cell at, const Stamp& stamp) {
  for (int y = 0; y < stamp.h; ++y) {
    for (int x = 0; x < stamp.w; ++x) painter.paint({at.x + x, at.y + y}, stamp.at(x, y));
  }
}

int floor_divide(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }  // b > 0
int floor_modulo(int a, int b) { return a - floor_divide(a, b) * b; }

// The tile that a stamp repeated from `origin` in all directions has at a cell.
std::uint8_t repeated(const Stamp& stamp, Cell origin, Cell c) {
  return stamp.at(floor_modulo(c.x - origin.x, stamp.w), floor_modulo(c.y - origin.y, stamp.h));
}

// The part of a rectangle that lies in a grid; w or h may be 0 or less.
CellRect cut(CellRect cells, int width, int height) {
  const int left = std::max(cells.x, 0), top = std::max(cells.y, 0);
  return {left, top, std::min(cells.x + cells.w, width) - left, std::min(cells.y + cells.h, height) - top};
}

template <class TileAt>
Stamp make_stamp(CellRect cells, TileAt tile_at) {
  if (cells.w < 1 || cells.h < 1) return {};
  Stamp stamp{cells.w, cells.h, {}};
  for (int y = cells.y; y < cells.y + cells.h; ++y) {
    for (int x = cells.x; x < cells.x + cells.w; ++x) stamp.tiles.push_back(tile_at(x, y));
  }
  return stamp;
}

}  // namespace

Stamp stamp_of_sheet(CellRect tiles) {
  return make_stamp(cut(tiles, kSheetColumns, kTileCount / kSheetColumns),
                    [](int x, int y) { return static_cast<std::uint8_t>(y * kSheetColumns + x); });
}

Stamp stamp_of_map(const Level& level, CellRect cells) {
  return make_stamp(cut(cells, level.map.width(), level.map.height()), [&](int x, int y) {
    return level.map.at({x, y});
  });
}

Edit paint_stamp(const Level& level, Cell at, const Stamp& stamp) {
  CellPainter painter(level.map);
  paint_one(painter, at, stamp);
  return painter.finish("Paint tiles");
}

Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  std::optional<Cell> last;
  for_each_on_line(from, to, [&](Cell c) {
    const Cell at{anchor.x + floor_divide(c.x - anchor.x, stamp.w) * stamp.w,
                  anchor.y + floor_divide(c.y - anchor.y, stamp.h) * stamp.h};
    if (last != at) paint_one(painter, at, stamp);
    last = at;
  });
  return painter.finish("Paint tiles");
}

Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  const CellRect part = cut(cells, level.map.width(), level.map.height());
  for (int y = part.y; y < part.y + part.h; ++y) {
    for (int x = part.x; x < part.x + part.w; ++x) {
      painter.paint({x, y}, repeated(stamp, {cells.x, cells.y}, {x, y}));
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
      painter.paint({x, y}, repeated(stamp, {cells.x, cells.y}, {x, y}));
  }
  return painter.finish("Outline rectangle");
}

Edit fill_ellipse(const Level& level, CellRect cells, const Stamp& stamp, Within within) {
  CellPainter painter(level.map, within);
  for (const Span& span : ellipse_spans(cells.w, cells.h)) {
    for (int x = span.first; x <= span.last; ++x)
      painter.paint({cells.x + x, cells.y + span.y}, repeated(stamp, {0, 0}, {x, span.y}));
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
      if (!is_inner) painter.paint({cells.x + x, cells.y + span.y}, repeated(stamp, {0, 0}, {x, span.y}));
    }
  }
  return painter.finish("Outline ellipse");
}

Edit flood_fill(const Level& level, Cell at, const Stamp& stamp, Within within) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  if (map.contains(at)) {
    const auto same = [&, tile = map.at(at)](Cell c) {
      return map.at(c) == tile && (!within || within->contains(c));
    };
    for (const Span& span : flood_area(map.width(), map.height(), at, same)) {
      for (int x = span.first; x <= span.last; ++x) {
        painter.paint({x, span.y}, repeated(stamp, at, {x, span.y}));
      }
    }
  }
  return painter.finish("Fill area");
}

Edit replace_tile(const Level& level, std::uint8_t tile, Cell origin, const Stamp& stamp, Within within) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  const CellRect part =
      cut(within.value_or(CellRect{0, 0, map.width(), map.height()}), map.width(), map.height());
  for (int y = part.y; y < part.y + part.h; ++y) {
    for (int x = part.x; x < part.x + part.w; ++x) {
      if (map.at({x, y}) == tile) painter.paint({x, y}, repeated(stamp, origin, {x, y}));
    }
  }
  return painter.finish("Replace tiles");
}

Edit erase_cells(const Level& level, CellRect cells) {
  Edit edit = fill_rect(level, cells, {});
  edit.label = "Erase tiles";
  return edit;
}

}  // namespace talus
