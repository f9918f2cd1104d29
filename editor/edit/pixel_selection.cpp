// Lifts pixels and puts them elsewhere.
#include "pixel_selection.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace talus {
namespace {

// `block` over `canvas`, cut off at its edge.
void lay_over(PixelBlock& canvas, const PixelBlock& block, Cell at) {
  for (int y = std::max(0, -at.y); y < std::min(block.h, canvas.h - at.y); ++y)
    for (int x = std::max(0, -at.x); x < std::min(block.w, canvas.w - at.x); ++x)
      canvas.colors[static_cast<std::size_t>(at.y + y) * canvas.w + at.x + x] = block.at(x, y);
}

CellRect clamped(const SpriteArea& area, CellRect rect) {
  const int right = std::clamp(rect.x + rect.w, 1, area.width());
  const int bottom = std::clamp(rect.y + rect.h, 1, area.height());
  const int x = std::clamp(rect.x, 0, right - 1), y = std::clamp(rect.y, 0, bottom - 1);
  return {x, y, right - x, bottom - y};
}

}  // namespace

bool PixelSelection::floats(const Level& level, const SpriteArea& area) const {
  return below_.w == area.width() && below_.h == area.height() &&
         copy_pixels(level, area, {0, 0, area.width(), area.height()}) == shown();
}

PixelBlock PixelSelection::pixels(const Level& level, const SpriteArea& area) const {
  assert(rect_);
  return floats(level, area) ? pixels_ : copy_pixels(level, area, clamped(area, *rect_));
}

void PixelSelection::select(const SpriteArea& area, CellRect rect) {
  drop();
  rect_ = clamped(area, rect);
}

void PixelSelection::drop() { *this = {}; }

void PixelSelection::check(const Level& level, const SpriteArea& area) {
  if (below_.w > 0 && !floats(level, area)) drop();
}

Edit PixelSelection::move(const Level& level, const SpriteArea& area, Cell by, PixelColor hole) {
  lift(level, area, hole);
  rect_->x += by.x;
  rect_->y += by.y;
  keep_inside(area);
  return put(level, area, "Move pixels");
}

Edit PixelSelection::turn(const Level& level, const SpriteArea& area, PixelTurn how, PixelColor hole) {
  lift(level, area, hole);
  pixels_ = turned(pixels_, how);
  // About its middle, if that is on the grid.
  rect_ = {rect_->x + (rect_->w - pixels_.w) / 2, rect_->y + (rect_->h - pixels_.h) / 2, pixels_.w,
           pixels_.h};
  keep_inside(area);
  return put(level, area, label_of(how));
}

Edit PixelSelection::paste(const Level& level, const SpriteArea& area, PixelBlock block, Cell at) {
  rect_ = {at.x, at.y, block.w, block.h};
  keep_inside(area);
  below_ = copy_pixels(level, area, {0, 0, area.width(), area.height()});
  pixels_ = std::move(block);
  return put(level, area, "Paste pixels");
}

void PixelSelection::lift(const Level& level, const SpriteArea& area, PixelColor hole) {
  assert(rect_);
  if (floats(level, area)) return;
  select(area, *rect_);
  pixels_ = copy_pixels(level, area, *rect_);
  below_ = copy_pixels(level, area, {0, 0, area.width(), area.height()});
  const std::vector<PixelColor> holes(pixels_.colors.size(), hole);
  lay_over(below_, {pixels_.w, pixels_.h, holes, pixels_.in_rgba}, {rect_->x, rect_->y});
}

PixelBlock PixelSelection::shown() const {
  PixelBlock canvas = below_;
  lay_over(canvas, pixels_, {rect_->x, rect_->y});
  return canvas;
}

Edit PixelSelection::put(const Level& level, const SpriteArea& area, std::string label) const {
  return put_pixels(level, area, shown(), {0, 0}, std::move(label));
}

void PixelSelection::keep_inside(const SpriteArea& area) {
  rect_->x = std::clamp(rect_->x, 1 - rect_->w, area.width() - 1);
  rect_->y = std::clamp(rect_->y, 1 - rect_->h, area.height() - 1);
}

}  // namespace talus
