// The tools of the pixel canvas, and the hand that holds one of them.
#pragma once

#include <map>
#include <memory>

#include "panels/ui/ui.h"
#include "pixel_tool.h"

namespace talus {

std::unique_ptr<PixelTool> make_pencil();
std::unique_ptr<PixelTool> make_color_picker();
std::unique_ptr<PixelTool> make_pixel_selector();
std::unique_ptr<PixelTool> make_pixel_fill();
std::unique_ptr<PixelTool> make_pixel_line();
std::unique_ptr<PixelTool> make_pixel_rectangle();
std::unique_ptr<PixelTool> make_pixel_ellipse();

// Uses the chosen tool. Escape, or another tool, ends a drag where it is.
class PixelToolHand {
 public:
  PixelToolHand();
  // pixel: under the mouse, inside of the canvas or not. hovered: the mouse is over the canvas. picks: the
  // middle button picks its colour now.
  void update(const Session& session, Actions& actions, Cell pixel, bool hovered, bool picks);
  bool active() const { return held_ != nullptr; }
  // Draws what the release would draw, the selection, and what the tool would touch at the mouse.
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, Cell pixel, bool hovered,
            float scale) const;

 private:
  PixelTool& chosen(const Session& session) const { return *tools_.at(session.choices().sprite_tool); }
  PixelToolUse use(const Session& session, Cell pixel) const {
    return {session, pixel, from_, last_, right_, stroke_};
  }

  std::map<SpriteTool, std::unique_ptr<PixelTool>> tools_;
  PixelTool* held_ = nullptr;  // the tool of the drag; null if there is no drag
  Cell from_, last_;
  bool right_ = false;
  int stroke_ = 0;
};

}  // namespace talus
