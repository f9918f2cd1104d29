// The rectangle tool: draws a rectangle; with Shift a square, with Ctrl a filled one.
#include "pixel_shape_tool.h"
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelRectangle : public PixelShapeTool {
  Edit shape(const PixelToolUse& use, PixelPen pen) const override {
    const ImGuiIO& io = ImGui::GetIO();
    const Cell to = io.KeyShift ? squared(use.from, use.pixel) : use.pixel;
    return draw_rectangle(use.session.level(), use.session.choices().area, use.from, to, pen, io.KeyCtrl);
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_rectangle() { return std::make_unique<PixelRectangle>(); }

}  // namespace talus
