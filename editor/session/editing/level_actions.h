// Actions: changing the level, also by the selected pixels of the sprite canvas; undo and redo.
#pragma once

#include <variant>

#include <talus/collision/geometry.h>
#include "edit/pixel_block.h"
#include "edit/sprite_turn.h"
#include "level/edit.h"

namespace talus {
namespace action {

struct EditLevel {  // an edit made by a tool; a stroke > 0 merges with an entry of the same stroke before it
  Edit edit;
  int stroke = 0;
};
// Makes a layer the one that tools work on. Is not an edit. Does nothing without such a layer.
struct ChooseLayer {
  int layer = 0;  // index in Level::layers
};
struct Undo {};
struct Redo {};

// Lifts the selected pixels from the canvas: the right button's colour stays behind, and they float until
// something else changes the canvas. All moves in a row are one undo. Does nothing without a selection.
struct MovePixels {
  Cell by;  // px
};
// The selected pixels in the same way, or the whole canvas, which must be square to rotate.
struct TurnPixels {
  PixelTurn turn = PixelTurn::flip_horizontal;
};
struct PastePixels {  // the pixels are selected, and float
  PixelBlock block;   // at least 1 px in each direction; of any kind of colours, see in_colors_of()
  Cell at;            // px of the canvas; at least one px stays inside
};

}  // namespace action

// The actions that LevelHandler carries out.
using LevelAction = std::variant<action::EditLevel, action::ChooseLayer, action::Undo, action::Redo,
                                 action::MovePixels, action::TurnPixels, action::PastePixels>;

}  // namespace talus
