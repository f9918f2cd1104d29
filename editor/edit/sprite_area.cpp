// Where the pixels of a canvas are on its sheet.
#include "sprite_area.h"

#include <cassert>
#include <utility>

namespace talus {
namespace {

// A change of one pixel of the area that changes nothing yet: before == after.
PixelChange pixel_of(const Level& level, const SpriteArea& area, Cell pixel) {
  assert(area.lies_in_sheet(level) && area.contains(pixel));
  const int tile = area.tile_at(level, pixel.x / kCartTileSize, pixel.y / kCartTileSize);
  const int index = pixel.y % kCartTileSize * kCartTileSize + pixel.x % kCartTileSize;
  const std::uint8_t color = level.sheet(area.sheet).images[tile][index];
  return {area.sheet, tile, index, color, color};
}

void paint_pixel(Edit& edit, const Level& level, const SpriteArea& area, Cell pixel, std::uint8_t color) {
  assert(color < kColorCount);
  PixelChange change = pixel_of(level, area, pixel);
  change.after = color;
  if (change.before != change.after) edit.changes.emplace_back(change);
}

}  // namespace

bool SpriteArea::contains(Cell pixel) const {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < width() && pixel.y < height();
}

bool SpriteArea::lies_in_sheet(const Level& level) const {
  const SheetLayout layout = level.sheet(sheet).layout();
  return tiles.w >= 1 && tiles.h >= 1 && layout.contains({tiles.x, tiles.y}) &&
         layout.contains({tiles.x + tiles.w - 1, tiles.y + tiles.h - 1});
}

SpriteArea cut_to_sheet(const Level& level, SpriteArea area) {
  const SheetLayout layout = level.sheet(area.sheet).layout();
  const auto part = shared(area.tiles, {0, 0, layout.columns, layout.rows()});
  area.tiles = part.value_or(CellRect{});
  const bool reaches_over_last = !area.lies_in_sheet(level);  // the last row may be shorter
  if (reaches_over_last && area.tiles.h > 1) --area.tiles.h;
  if (!area.lies_in_sheet(level)) area.tiles = {};
  return area;
}

std::uint8_t pixel_at(const Level& level, const SpriteArea& area, int x, int y) {
  return pixel_of(level, area, {x, y}).before;
}

PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect) {
  PixelBlock block{rect.w, rect.h, {}};
  block.colors.reserve(static_cast<std::size_t>(rect.w) * rect.h);
  for (int y = rect.y; y < rect.y + rect.h; ++y)
    for (int x = rect.x; x < rect.x + rect.w; ++x) block.colors.push_back(pixel_at(level, area, x, y));
  return block;
}

Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label) {
  Edit edit{std::move(label), {}};
  for (int y = 0; y < block.h; ++y) {
    for (int x = 0; x < block.w; ++x) {
      const Cell pixel{at.x + x, at.y + y};
      if (area.contains(pixel)) paint_pixel(edit, level, area, pixel, block.at(x, y));
    }
  }
  return edit;
}

}  // namespace talus
