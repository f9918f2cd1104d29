// Fills connected pixels, or all pixels of one colour.
#include "sprite_fill.h"

#include <algorithm>

#include "raster.h"

namespace talus {

Edit fill_pixels(const Level& level, const SpriteArea& area, Cell at, PixelColor color) {
  if (!area.contains(at)) return {"Fill pixels", {}};
  PixelBlock canvas = copy_pixels(level, area, area.canvas());
  const auto same = [&, old = canvas.at(at.x, at.y)](Cell c) { return canvas.at(c.x, c.y) == old; };
  const auto spans = flood_area(area.width(), area.height(), at, same);
  for (const Span& span : spans) {
    const auto row = canvas.colors.begin() + std::ptrdiff_t{span.y} * canvas.w;
    std::fill(row + span.first, row + span.last + 1, color);
  }
  return put_pixels(level, area, canvas, {0, 0}, "Fill pixels");
}

Edit replace_color(const Level& level, const SpriteArea& area, PixelColor from, PixelColor to) {
  PixelBlock canvas = copy_pixels(level, area, area.canvas());
  std::replace(canvas.colors.begin(), canvas.colors.end(), from, to);
  return put_pixels(level, area, canvas, {0, 0}, "Replace colour");
}

}  // namespace talus
