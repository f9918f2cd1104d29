// The fill of the sprite canvas. It makes an Edit and changes nothing itself.
#pragma once

#include "sprite_area.h"

namespace talus {

// Fills the 4-connected area of one colour around a pixel; nothing outside of the canvas.
Edit fill_pixels(const Level& level, const SpriteArea& area, Cell at, PixelColor color);
// Replaces all pixels of a colour, wherever they are.
Edit replace_color(const Level& level, const SpriteArea& area, PixelColor from, PixelColor to);

}  // namespace talus
