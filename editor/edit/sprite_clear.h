// Clears the sprite canvas, or a part of it.
#pragma once

#include "sprite_area.h"

namespace talus {

// Fills the area with a colour and clears its flags, as TIC-80 does when it erases a whole sprite.
Edit clear_area(const Level& level, const SpriteArea& area, PixelColor color);
// Fills a rectangle of the canvas in px; parts outside of it are left out.
Edit clear_pixels(const Level& level, const SpriteArea& area, CellRect rect, PixelColor color);

}  // namespace talus
