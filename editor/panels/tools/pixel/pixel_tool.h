// PixelTool: what a mouse button does on the pixel canvas, from the press to the release. Each tool is a file
// of this folder; pixel_tools.cpp has the table.
#pragma once

#include "panels/canvas/camera.h"
#include "session/session.h"

namespace talus {

// The place of the mouse, and the current drag.
struct PixelToolUse {
  const Session& session;
  Cell pixel;          // under the mouse, inside of the canvas or not
  Cell from = {};      // px, where the button went down
  Cell last = {};      // px, the drag's place before this frame
  bool right = false;  // whether it is the right button, with its colour
  int stroke = 0;      // for the drag's edits, so that they are one undo

  PixelColor color() const { return session.choices().paint(session.level(), right); }
};

// Gives a button the colour of a pixel, which must be inside of the canvas. right: the right button.
inline void take_color(const Session& session, Cell pixel, bool right, Actions& actions) {
  const SpriteArea& area = session.choices().area;
  const PixelColor color = pixel_at(session.level(), area, pixel.x, pixel.y);
  if (is_in_rgba(session.level(), area.sheet))
    actions.push_back(action::SetRgba{rgba_of(color), right});
  else
    actions.push_back(action::SetColor{color, right});
}

class PixelTool {
 public:
  virtual ~PixelTool() = default;
  // The button goes down, on the canvas.
  virtual void press(const PixelToolUse&, Actions&) {}
  // The mouse has moved to another pixel.
  virtual void drag(const PixelToolUse&, Actions&) {}
  // The button goes up; called after drag().
  virtual void release(const PixelToolUse&, Actions&) {}
  // During a drag: what the release would draw.
  virtual void draw(ImDrawList&, const PixelToolUse&, const CanvasView&) const {}
  virtual bool uses_brush() const { return false; }
};

}  // namespace talus
