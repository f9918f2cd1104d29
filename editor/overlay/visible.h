// Rectangles: tests of what is visible.
#pragma once

#include <algorithm>

#include <talus/collision/geometry.h>

namespace talus {

// Whether the rectangles overlap or touch.
inline bool meet(const Rect& a, const Rect& b) {
  return a.right() >= b.x && a.x <= b.right() && a.bottom() >= b.y && a.y <= b.bottom();
}

// Whether the box around a line touches the rectangle.
inline bool meets(Vec2 a, Vec2 b, const Rect& r) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return meet({x, y, std::max(a.x, b.x) - x, std::max(a.y, b.y) - y}, r);
}

// The smallest rectangle around two others.
inline Rect joined_rect(const Rect& a, const Rect& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

}  // namespace talus
