// The tools that draw a shape into a dragged box: a rectangle and an ellipse. With Shift the box is a square,
// with Ctrl the shape is filled.
#include "pixel_shape_tool.h"
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelBoxShape : public PixelShapeTool {
 public:
  // by: draw_rectangle or draw_ellipse.
  explicit PixelBoxShape(decltype(draw_rectangle)* by) : draw_(by) {}

 private:
  Edit shape(const PixelToolUse& use, PixelPen pen) const override {
    const ImGuiIO& io = ImGui::GetIO();
    const Cell to = io.KeyShift ? squared(use.from, use.pixel) : use.pixel;
    return draw_(use.session.level(), use.session.choices().area, use.from, to, pen, io.KeyCtrl);
  }

  decltype(draw_rectangle)* draw_;
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_rectangle() { return std::make_unique<PixelBoxShape>(draw_rectangle); }
std::unique_ptr<PixelTool> make_pixel_ellipse() { return std::make_unique<PixelBoxShape>(draw_ellipse); }

}  // namespace talus
