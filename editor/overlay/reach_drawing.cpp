// Draws reached cells as few boxes.
#include "reach_drawing.h"

#include <algorithm>
#include <cmath>

#include "overlay_pen.h"

namespace talus {
namespace {

constexpr double kMaxCells =
    65'536;  // cells that are tested at most; beyond that, one cell stands for its neighbours

int cell_within(double px, int side, int count) {
  return static_cast<int>(std::clamp(std::floor(px / side), 0.0, static_cast<double>(count)));
}

}  // namespace

void add_reach(const ReachSearch& reach, bool stale, const TileMap& map, Rect visible,
               OverlayDrawing& drawing) {
  const auto [width, height] = map.tile_size();
  const int x0 = cell_within(visible.x, width, map.width());
  const int x1 = cell_within(visible.right() + width, width, map.width());
  const int y0 = cell_within(visible.y, height, map.height());
  const int y1 = cell_within(visible.bottom() + height, height, map.height());
  const double count = 1.0 * (x1 - x0) * (y1 - y0);
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(count / kMaxCells))));
  // Joins equal cells of a row.
  const auto runs = [&](int y, auto is_in, auto put) {
    int start = x0;
    for (int x = x0; x < x1 + step; x += step) {
      if (x < x1 && is_in(Cell{x, y})) continue;
      if (x > start) put(map.x_of(start), map.x_of(std::min(x, x1)));
      start = x + step;
    }
  };
  // A run below an equal run makes its box higher.
  std::vector<Rect> open, here;
  const auto close = [&](const Rect& box) { drawing.boxes.push_back({&overlay::reach, box, !stale}); };
  for (int y = y0; y < y1; y += step) {
    const double top = map.y_of(y), bottom = map.y_of(std::min(y + step, y1));
    here.clear();
    runs(
        y, [&](Cell c) { return reach.reached(c); },
        [&](double from, double to) {
          const auto above = std::find_if(
              open.begin(), open.end(), [&](const Rect& box) { return box.x == from && box.w == to - from; });
          here.push_back({from, above != open.end() ? above->y : top, to - from, 0});
          here.back().h = bottom - here.back().y;
          if (above != open.end()) open.erase(above);
        });
    std::for_each(open.begin(), open.end(), close);
    open.swap(here);
    runs(
        y, [&](Cell c) { return reach.stood_at(c); },
        [&](double from, double to) {
          drawing.lines.push_back({&overlay::reach, {from, bottom}, {to, bottom}});
        });
  }
  std::for_each(open.begin(), open.end(), close);
}

namespace {

void draw_reach(const OverlaySource& source, OverlayPen& pen) {
  if (source.reach == nullptr) return;
  add_reach(*source.reach, source.reach_is_stale, source.level->map, pen.visible(), pen.drawing());
}

}  // namespace

namespace overlay {

const Overlay reach{
    .key = "reach",
    .label = "reach",
    .help = "Cells that a player can get to from its start, and the floors that it stood on there.",
    .group = OverlayGroup::ground,
    .color = 0x8bd450,
    .safe_color = 0xc8ff00,
    .digit = '7',
    .shift = true,
    .needs_reach = true,
    .layer = 2,
    .draw = draw_reach,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({0, 0, 8, 7}, true);
          pen.line({0, 7}, {8, 7});
        },
};

}  // namespace overlay
}  // namespace talus
