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

  std::uint8_t color() const {
    const Choices& choices = session.choices();
    return static_cast<std::uint8_t>(right ? choices.secondary_color : choices.color);
  }
};

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
