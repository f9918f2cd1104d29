// How single curves, their handles and the marks of snapped points look on a canvas.
#pragma once

#include <string>

#include "camera.h"
#include "edit/curve_tools.h"
#include "edit/snap.h"
#include "panels/ui/ui.h"

namespace talus {

std::string position_text(Vec2 p);  // "12, 40.5"

class CurvePen {
 public:
  CurvePen(ImDrawList& list, const CanvasView& view, float width) : list_(list), view_(view), width_(width) {}

  void line(Vec2 from, Vec2 to, ImU32 color) const;
  void stroke(const Curve& curve, ImU32 color) const;  // the curve must be good
  // Squares at its ends, circles at the handles that bend it; `lit`: the handle that is held or pointed at,
  // -1: no handle.
  void handles(const Curve& curve, int lit, Ui& ui) const;
  // Beside a place on the screen, inside of the canvas. color: 0xRRGGBB.
  void title(const std::string& text, ImVec2 beside, std::uint32_t color) const;
  // A mark that shows what the point snapped to: a ring with a word for an end, a square for a tile's border,
  // a diamond for half a pixel, a dot for a pixel. word: one more word beside it; may be empty.
  void snapped(const SnappedPoint& point, const Ui& ui, std::string_view word = {}) const;

 private:
  ImDrawList& list_;
  const CanvasView& view_;
  float width_;
};

}  // namespace talus
