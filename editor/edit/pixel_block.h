// PixelBlock: a rectangle of pixels apart from any sheet, and how it is turned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pixel_color.h"

namespace talus {

struct PixelBlock {
  int w = 0, h = 0;                // px
  std::vector<PixelColor> colors;  // w * h, row by row
  bool in_rgba = false;            // whether they are those of a sheet in true colour
  PixelColor at(int x, int y) const { return colors[static_cast<std::size_t>(y) * w + x]; }
  friend bool operator==(const PixelBlock&, const PixelBlock&) = default;
};

// Shifts move by one px; pixels that leave at one side come in at the other.
enum class PixelTurn {
  flip_horizontal,
  flip_vertical,
  rotate,  // by 90 degrees, clockwise: width and height change places
  shift_left,
  shift_right,
  shift_up,
  shift_down
};

PixelBlock turned(const PixelBlock& block, PixelTurn turn);
std::string label_of(PixelTurn turn);  // for the history: "Flip horizontally"

}  // namespace talus
