// PixelShapeTool: the base of tools that draw a shape from the press to the release.
#pragma once

#include "pixel_tool.h"

namespace talus {

class PixelShapeTool : public PixelTool {
 public:
  void release(const PixelToolUse& use, Actions& actions) override;
  void draw(ImDrawList& list, const PixelToolUse& use, const CanvasView& view) const override;
  bool uses_brush() const override { return true; }

 private:
  // Draws with the brush's colour, and with Shift and Ctrl as they are held.
  virtual Edit shape(const PixelToolUse& use, PixelPen pen) const = 0;
  Edit shape(const PixelToolUse& use) const { return shape(use, {use.color(), use.session.choices().brush}); }
};

}  // namespace talus
