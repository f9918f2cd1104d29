// A canvas of 8x8 px as eight lines of text, so that a test shows its picture.
#pragma once

#include <string>

#include "edit/sprite_area.h"

namespace talus {

// A hex digit for each pixel, and '.' for colour 0.
inline std::string picture_of(const Level& level, const SpriteArea& area) {
  std::string text;
  for (int y = 0; y < area.height(); ++y) {
    for (int x = 0; x < area.width(); ++x) text += ".123456789abcdef"[pixel_at(level, area, x, y)];
    text += '\n';
  }
  return text;
}

// Returns `level` with this picture on the canvas.
inline Level with_picture(Level level, const SpriteArea& area, const std::string& text) {
  PixelBlock block{area.width(), area.height(), {}};
  for (char c : text)
    if (c != '\n') block.colors.push_back(static_cast<std::uint8_t>(std::string(".123456789abcdef").find(c)));
  apply_edit(level, put_pixels(level, area, block, {0, 0}, ""));
  return level;
}

}  // namespace talus
