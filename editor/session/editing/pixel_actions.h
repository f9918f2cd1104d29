// Actions: changing the selected pixels of the sprite canvas.
#pragma once

#include <variant>

#include <talus/collision/geometry.h>
#include "edit/pixel_block.h"
#include "edit/sprite_turn.h"

namespace talus {
namespace action {

// The selected pixels are lifted from the canvas: the right button's colour stays behind, and they float
// until something else changes the canvas. All moves in a row are one undo. Without a selection nothing
// happens.
struct MovePixels {
  Cell by;  // px
};
struct TurnPixels {  // the selected ones, in the same way, or all of the canvas, which rotates if it is
                     // square
  PixelTurn turn = PixelTurn::flip_horizontal;
};
struct PastePixels {  // they are selected, and float
  PixelBlock block;   // 1 px or more in each direction
  Cell at;            // px of the canvas; one px stays inside
};

}  // namespace action

// What PixelHandler carries out.
using PixelAction = std::variant<action::MovePixels, action::TurnPixels, action::PastePixels>;

}  // namespace talus
