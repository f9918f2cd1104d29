// Turns blocks of pixels.
#include "pixel_block.h"

namespace talus {
namespace {

template <class ColorAt>
PixelBlock block_of(int w, int h, bool in_rgba, ColorAt color_at) {
  PixelBlock block{w, h, {}, in_rgba};
  block.colors.reserve(static_cast<std::size_t>(w) * h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) block.colors.push_back(color_at(x, y));
  return block;
}

}  // namespace

PixelBlock turned(const PixelBlock& b, PixelTurn turn) {
  switch (turn) {
    case PixelTurn::flip_horizontal:
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at(b.w - 1 - x, y); });
    case PixelTurn::flip_vertical:
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at(x, b.h - 1 - y); });
    case PixelTurn::rotate:
      return block_of(b.h, b.w, b.in_rgba, [&](int x, int y) { return b.at(y, b.h - 1 - x); });
    case PixelTurn::shift_left:
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at((x + 1) % b.w, y); });
    case PixelTurn::shift_right:
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at((x + b.w - 1) % b.w, y); });
    case PixelTurn::shift_up:
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at(x, (y + 1) % b.h); });
    default:  // shift_down
      return block_of(b.w, b.h, b.in_rgba, [&](int x, int y) { return b.at(x, (y + b.h - 1) % b.h); });
  }
}

std::string label_of(PixelTurn turn) {
  switch (turn) {
    case PixelTurn::flip_horizontal:
      return "Flip horizontally";
    case PixelTurn::flip_vertical:
      return "Flip vertically";
    case PixelTurn::rotate:
      return "Rotate";
    case PixelTurn::shift_left:
      return "Shift left";
    case PixelTurn::shift_right:
      return "Shift right";
    case PixelTurn::shift_up:
      return "Shift up";
    default:  // shift_down
      return "Shift down";
  }
}

}  // namespace talus
