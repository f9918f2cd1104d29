// The tools of the map.
#include "map_tools.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "raster.h"

namespace talus {
namespace {

// Collects what a tool paints. Past a number of cells a copy of the map takes less memory than their list.
class CellPainter {
 public:
  explicit CellPainter(const TileMap& map)
      : map_(map), max_listed_(std::max<std::size_t>(256, 2 * map.cells().size() / sizeof(Change))) {}

  // A cell may be painted once; one outside the map is left out.
  void paint(Cell cell, std::uint8_t tile) {
    if (!map_.contains(cell) || map_.at(cell) == tile) return;
    if (whole_) {
      whole_->set(cell, tile);
      return;
    }
    changes_.push_back({cell, map_.at(cell), tile});
    if (changes_.size() <= max_listed_) return;
    whole_ = map_;
    for (const CellChange& change : changes_) whole_->set(change.cell, change.after);
  }

  Edit finish(std::string label) {
    Edit edit{std::move(label), {}};
    if (whole_) {
      edit.changes.emplace_back(MapChange{map_, *std::move(whole_)});
    } else {
      edit.changes.assign(changes_.begin(), changes_.end());
    }
    return edit;
  }

 private:
  const TileMap& map_;
  std::size_t max_listed_;
  std::vector<CellChange> changes_;
  std::optional<TileMap> whole_;
};

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

Edit fill_labelled(const Level& level, CellRect cells, const Stamp& stamp, std::string label) {
  CellPainter painter(level.map);
  const CellRect part = cut(cells, level.map.width(), level.map.height());
  for (int y = part.y; y < part.y + part.h; ++y) {
    for (int x = part.x; x < part.x + part.w; ++x) {
      painter.paint({x, y}, repeated(stamp, {cells.x, cells.y}, {x, y}));
    }
  }
  return painter.finish(std::move(label));
}

}  // namespace

CellRect spanned(Cell a, Cell b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x, b.x) - left + 1, std::max(a.y, b.y) - top + 1};
}

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

Edit paint_stroke(const Level& level, Cell anchor, Cell from, Cell to, const Stamp& stamp) {
  CellPainter painter(level.map);
  std::optional<Cell> last;
  for_each_on_line(from, to, [&](Cell c) {
    const Cell at{anchor.x + floor_divide(c.x - anchor.x, stamp.w) * stamp.w,
                  anchor.y + floor_divide(c.y - anchor.y, stamp.h) * stamp.h};
    if (last != at) paint_one(painter, at, stamp);
    last = at;
  });
  return painter.finish("Paint tiles");
}

Edit fill_rect(const Level& level, CellRect cells, const Stamp& stamp) {
  return fill_labelled(level, cells, stamp, "Fill rectangle");
}

Edit flood_fill(const Level& level, Cell at, const Stamp& stamp) {
  const TileMap& map = level.map;
  CellPainter painter(map);
  if (map.contains(at)) {
    const auto same = [&, tile = map.at(at)](Cell c) { return map.at(c) == tile; };
    for (const Span& span : flood_area(map.width(), map.height(), at, same)) {
      for (int x = span.first; x <= span.last; ++x) {
        painter.paint({x, span.y}, repeated(stamp, at, {x, span.y}));
      }
    }
  }
  return painter.finish("Fill area");
}

Edit erase_cells(const Level& level, CellRect cells) {
  return fill_labelled(level, cells, {}, "Erase tiles");
}

}  // namespace talus
