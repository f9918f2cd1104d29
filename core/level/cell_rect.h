// CellRect: a rectangle of cells of the map, or of tiles of a sheet.
#pragma once

#include <algorithm>
#include <optional>

#include <talus/collision/geometry.h>

namespace talus {

struct CellRect {
  int x = 0, y = 0, w = 1, h = 1;  // cells; w, h >= 1
  bool contains(Cell c) const { return c.x >= x && c.y >= y && c.x < x + w && c.y < y + h; }
  friend bool operator==(const CellRect&, const CellRect&) = default;
};

// The smallest rectangle that contains both.
inline CellRect spanned(Cell a, Cell b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x, b.x) - left + 1, std::max(a.y, b.y) - top + 1};
}

// The part that two rectangles share; nothing if they do not meet.
inline std::optional<CellRect> shared(const CellRect& a, const CellRect& b) {
  const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
  const int w = std::min(a.x + a.w, b.x + b.w) - left, h = std::min(a.y + a.h, b.y + b.h) - top;
  if (w < 1 || h < 1) return std::nullopt;
  return CellRect{left, top, w, h};
}

}  // namespace talus
