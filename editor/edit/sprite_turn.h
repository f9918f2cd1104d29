// Flips, turns and shifts of the sprite canvas.
#pragma once

#include "sprite_area.h"

namespace talus {

// The area must be square for rotation (asserted).
Edit turn_pixels(const Level& level, const SpriteArea& area, PixelTurn turn);

}  // namespace talus
