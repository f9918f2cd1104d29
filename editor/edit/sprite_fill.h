// The fill of the sprite canvas. It makes an Edit and changes nothing itself.
#pragma once

#include "sprite_area.h"

namespace talus {

// The 4-connected area of one colour around a pixel; of none outside the canvas.
Edit fill_pixels(const Level& level, const SpriteArea& area, Cell at, std::uint8_t color);
// All pixels of a colour, wherever they are.
Edit replace_color(const Level& level, const SpriteArea& area, std::uint8_t from, std::uint8_t to);

}  // namespace talus
