// Bresenham's line, a scanline flood fill and the rows of an ellipse.
#include "raster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace talus {

void for_each_on_line(Cell from, Cell to, FunctionRef<void(Cell)> visit) {
  const int dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
  const int step_x = from.x < to.x ? 1 : -1, step_y = from.y < to.y ? 1 : -1;
  int error = dx + dy;
  for (Cell c = from;;) {
    visit(c);
    if (c == to) return;
    const int twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      c.x += step_x;
    }
    if (twice <= dx) {
      error += dx;
      c.y += step_y;
    }
  }
}

std::vector<Span> flood_area(int width, int height, Cell at, FunctionRef<bool(Cell)> inside) {
  std::vector<Span> area;
  if (at.x < 0 || at.y < 0 || at.x >= width || at.y >= height) return area;
  std::vector<bool> visited(static_cast<std::size_t>(width) * height);
  const auto is_open = [&](Cell c) {
    return !visited[static_cast<std::size_t>(c.y) * width + c.x] && inside(c);
  };
  std::vector<Cell> seeds;
  // One seed for each run of open cells in a row below or above a finished span.
  const auto seed_row = [&](int y, int first, int last) {
    if (y < 0 || y >= height) return;
    for (int x = first; x <= last; ++x) {
      if (is_open({x, y}) && (x == first || !is_open({x - 1, y}))) seeds.push_back({x, y});
    }
  };
  seeds.push_back(at);
  while (!seeds.empty()) {
    const Cell seed = seeds.back();
    seeds.pop_back();
    if (!is_open(seed)) continue;
    Span span{seed.y, seed.x, seed.x};
    while (span.first > 0 && is_open({span.first - 1, span.y})) --span.first;
    while (span.last < width - 1 && is_open({span.last + 1, span.y})) ++span.last;
    for (int x = span.first; x <= span.last; ++x)
      visited[static_cast<std::size_t>(span.y) * width + x] = true;
    area.push_back(span);
    seed_row(span.y - 1, span.first, span.last);
    seed_row(span.y + 1, span.first, span.last);
  }
  return area;
}

std::vector<Span> ellipse_spans(int width, int height) {
  std::vector<Span> spans;
  spans.reserve(static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const double v = static_cast<double>(2 * y + 1 - height) / height;
    const double half = width * std::sqrt(1 - v * v) / 2;
    // Columns are counted from either side, so that the halves are mirror images.
    const int first = std::clamp(static_cast<int>(std::ceil((width - 1) / 2.0 - half)), 0, (width - 1) / 2);
    spans.push_back({y, first, width - 1 - first});
  }
  return spans;
}

}  // namespace talus
