// The ellipse tool: draws an ellipse; with Shift a circle, with Ctrl a filled one.
#include "pixel_shape_tool.h"
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelEllipse : public PixelShapeTool {
  Edit shape(const PixelToolUse& use, PixelPen pen) const override {
    const ImGuiIO& io = ImGui::GetIO();
    const Cell to = io.KeyShift ? squared(use.from, use.pixel) : use.pixel;
    return draw_ellipse(use.session.level(), use.session.choices().area, use.from, to, pen, io.KeyCtrl);
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_ellipse() { return std::make_unique<PixelEllipse>(); }

}  // namespace talus
