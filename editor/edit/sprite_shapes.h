// Tools that draw lines, rectangles and ellipses of pixels on a canvas. What lies outside it is left out.
#pragma once

#include "sprite_area.h"

namespace talus {

inline constexpr int kMaxBrush = 4;  // px

struct PixelPen {
  PixelColor color = 0;
  int brush = 1;  // px, side of its square, 1..kMaxBrush (asserted)
};
// The pixels that the brush covers when the mouse is on a pixel: centred on it, or shifted to the right and
// down if the brush has no middle pixel.
CellRect brush_at(Cell pixel, int brush);

// The straight line between two points, both included.
Edit draw_line(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen);
// With these corners.
Edit draw_rectangle(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen,
                    bool filled);
// The largest ellipse within these corners.
Edit draw_ellipse(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen, bool filled);

// The point near `to` on the nearest horizontal, vertical or diagonal line through `from`.
Cell straightened(Cell from, Cell to);
// The corner of the smallest square from `from` that reaches as far as `to`, on the same side.
Cell squared(Cell from, Cell to);

}  // namespace talus
