// Clears by putting a block of one colour.
#include "sprite_clear.h"

#include "flag_lamps.h"

namespace talus {

Edit clear_area(const Level& level, const SpriteArea& area, PixelColor color) {
  Edit edit = clear_pixels(level, area, area.canvas(), color);
  const std::vector<FlagSet> none(static_cast<std::size_t>(area.tiles.w) * area.tiles.h, 0);
  const Edit flags = set_flags(level, area, none);
  edit.changes.insert(edit.changes.end(), flags.changes.begin(), flags.changes.end());
  return edit;
}

Edit clear_pixels(const Level& level, const SpriteArea& area, CellRect rect, PixelColor color) {
  const PixelBlock block{rect.w, rect.h,
                         std::vector<PixelColor>(static_cast<std::size_t>(rect.w) * rect.h, color),
                         is_in_rgba(level, area.sheet)};
  return put_pixels(level, area, block, {rect.x, rect.y}, "Clear");
}

}  // namespace talus
