// The line tool: draws a straight line; with Shift a horizontal, vertical or diagonal one.
#include "pixel_shape_tool.h"
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelLine : public PixelShapeTool {
  Edit shape(const PixelToolUse& use, PixelPen pen) const override {
    const Cell to = ImGui::GetIO().KeyShift ? straightened(use.from, use.pixel) : use.pixel;
    Edit edit = draw_line(use.session.level(), use.session.choices().area, use.from, to, pen);
    edit.label = "Draw a line";
    return edit;
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_line() { return std::make_unique<PixelLine>(); }

}  // namespace talus
