// SpriteGesture: what the mouse does on the pixel canvas with the chosen tool.
#pragma once

#include <optional>

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

class SpriteGesture {
 public:
  // pixel: under the mouse, inside the canvas or not. hovered: the mouse is over the canvas.
  void update(const Session& session, Actions& actions, Cell pixel, bool hovered);
  bool active() const { return from_.has_value(); }
  // The shape that letting go would draw, the selection, and what the tool would touch at the mouse.
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, Cell pixel, bool hovered,
            float scale) const;

 private:
  void press(const Session& session, Actions& actions, Cell pixel, bool right);
  void drag(const Session& session, Actions& actions, Cell pixel);
  void release(const Session& session, Actions& actions, Cell pixel);
  std::uint8_t color(const Choices& choices) const;
  Edit line_to(const Session& session, Cell pixel) const;
  Edit shape_to(const Session& session, Cell pixel) const;

  std::optional<Cell> from_;  // px, where the button went down
  Cell last_;                 // px, where the drag has come to
  SpriteTool tool_ = SpriteTool::pencil;
  bool right_ = false;      // the right button's, with its colour
  bool moves_ = false;      // the selected pixels
  bool deselects_ = false;  // if it goes nowhere
  int stroke_ = 0;
};

}  // namespace talus
