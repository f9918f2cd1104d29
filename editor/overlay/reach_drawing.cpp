#include "reach_drawing.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double kMostCells = 65'536;  // that are looked at; beyond, one stands for its neighbours

int cell_within(double px, int count) {
  return static_cast<int>(std::clamp(std::floor(px / kTileSize), 0.0, static_cast<double>(count)));
}

}  // namespace

void add_reach(const ReachSearch& reach, bool stale, int columns, int rows, Rect visible,
               OverlayDrawing& drawing) {
  const int x0 = cell_within(visible.x, columns), x1 = cell_within(visible.right() + kTileSize, columns);
  const int y0 = cell_within(visible.y, rows), y1 = cell_within(visible.bottom() + kTileSize, rows);
  const double count = 1.0 * (x1 - x0) * (y1 - y0);
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(count / kMostCells))));
  const auto px = [](int cell) { return cell * 1.0 * kTileSize; };
  // Cells of a row that are alike, as one.
  const auto runs = [&](int y, auto is_in, auto put) {
    int start = x0;
    for (int x = x0; x < x1 + step; x += step) {
      if (x < x1 && is_in(Cell{x, y})) continue;
      if (x > start) put(px(start), px(std::min(x, x1)));
      start = x + step;
    }
  };
  for (int y = y0; y < y1; y += step) {
    const double bottom = px(std::min(y + step, y1));
    runs(
        y, [&](Cell c) { return reach.reached(c); },
        [&](double from, double to) {
          drawing.boxes.push_back({OverlayId::reach, {from, px(y), to - from, bottom - px(y)}, !stale});
        });
    runs(
        y, [&](Cell c) { return reach.stood_at(c); },
        [&](double from, double to) {
          drawing.lines.push_back({OverlayId::reach, {from, bottom}, {to, bottom}});
        });
  }
}

}  // namespace talus
