// A shape is a set of pixels that is painted once.
#include "sprite_shapes.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include <talus/collision/function_ref.h>
#include "raster.h"

namespace talus {
namespace {

// The pixels of a canvas that a shape covers. Its brush may go over a pixel several times.
class Mask {
 public:
  // box: px of the canvas; the brush goes along pixels in it.
  Mask(const SpriteArea& area, CellRect box)
      : part_(shared(area.canvas(),
                     {box.x - kMaxBrush, box.y - kMaxBrush, box.w + 2 * kMaxBrush, box.h + 2 * kMaxBrush})) {
    if (part_) covered_.resize(static_cast<std::size_t>(part_->w) * part_->h);
  }

  void cover(CellRect rect) {
    const auto inside = part_ ? shared(rect, *part_) : std::nullopt;
    if (!inside) return;
    for (int y = inside->y; y < inside->y + inside->h; ++y)
      for (int x = inside->x; x < inside->x + inside->w; ++x) covered_[index(x, y)] = true;
  }
  Edit paint(const Level& level, const SpriteArea& area, PixelColor color, std::string label) const {
    if (!part_) return {std::move(label), {}};
    PixelBlock block = copy_pixels(level, area, *part_);
    for (std::size_t i = 0; i < covered_.size(); ++i)
      if (covered_[i]) block.colors[i] = color;
    return put_pixels(level, area, block, {part_->x, part_->y}, std::move(label));
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - part_->y) * part_->w + (x - part_->x);
  }
  std::optional<CellRect> part_;  // px of the canvas that the shape can cover; nothing: it is outside
  std::vector<bool> covered_;     // by pixel of that
};

// A shape whose `inside` knows every pixel of `box`. Pixels with a side neighbour outside of the shape make
// the outline.
Edit draw_shape(const Level& level, const SpriteArea& area, CellRect box, PixelPen pen, bool filled,
                FunctionRef<bool(int, int)> inside, std::string label) {
  Mask mask(area, box);
  const auto is_edge = [&](int x, int y) {
    return !inside(x - 1, y) || !inside(x + 1, y) || !inside(x, y - 1) || !inside(x, y + 1);
  };
  for (int y = 0; y < box.h; ++y) {
    for (int x = 0; x < box.w; ++x) {
      if (!inside(x, y)) continue;
      if (filled) mask.cover({box.x + x, box.y + y, 1, 1});
      if (is_edge(x, y)) mask.cover(brush_at({box.x + x, box.y + y}, pen.brush));
    }
  }
  return mask.paint(level, area, pen.color, std::move(label));
}

int sign(int v) { return v < 0 ? -1 : 1; }

}  // namespace

CellRect brush_at(Cell pixel, int brush) {
  assert(brush >= 1 && brush <= kMaxBrush);
  return {pixel.x - (brush - 1) / 2, pixel.y - (brush - 1) / 2, brush, brush};
}

Edit draw_line(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen) {
  Mask mask(area, spanned(from, to));
  for_each_on_line(from, to, [&](Cell pixel) { mask.cover(brush_at(pixel, pen.brush)); });
  return mask.paint(level, area, pen.color, "Draw pixels");
}

Edit draw_rectangle(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen,
                    bool filled) {
  const CellRect box = spanned(from, to);
  const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < box.w && y < box.h; };
  return draw_shape(level, area, box, pen, filled, inside, "Draw a rectangle");
}

Edit draw_ellipse(const Level& level, const SpriteArea& area, Cell from, Cell to, PixelPen pen, bool filled) {
  const CellRect box = spanned(from, to);
  const std::int64_t w = box.w, h = box.h;
  // Pixels whose middle lies in the ellipse that touches all sides of the box; in half px.
  const auto inside = [&](int x, int y) {
    const std::int64_t dx = 2 * x + 1 - w, dy = 2 * y + 1 - h;
    return dx * dx * h * h + dy * dy * w * w <= w * w * h * h;
  };
  return draw_shape(level, area, box, pen, filled, inside, "Draw an ellipse");
}

Cell straightened(Cell from, Cell to) {
  const int dx = to.x - from.x, dy = to.y - from.y;
  if (std::abs(dx) > 2 * std::abs(dy)) return {to.x, from.y};
  if (std::abs(dy) > 2 * std::abs(dx)) return {from.x, to.y};
  return squared(from, to);
}

Cell squared(Cell from, Cell to) {
  const int dx = to.x - from.x, dy = to.y - from.y, side = std::max(std::abs(dx), std::abs(dy));
  return {from.x + sign(dx) * side, from.y + sign(dy) * side};
}

}  // namespace talus
