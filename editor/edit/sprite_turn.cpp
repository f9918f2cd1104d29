// Takes the canvas as a block, turns it, and puts it back.
#include "sprite_turn.h"

#include <cassert>

namespace talus {

Edit turn_pixels(const Level& level, const SpriteArea& area, PixelTurn turn) {
  assert(turn != PixelTurn::rotate || area.width() == area.height());
  const PixelBlock canvas = copy_pixels(level, area, area.canvas());
  return put_pixels(level, area, turned(canvas, turn), {0, 0}, label_of(turn));
}

}  // namespace talus
