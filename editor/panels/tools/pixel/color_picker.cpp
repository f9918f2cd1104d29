// The colour picker: takes the colour of the pixel under the press, for the button that was pressed.
#include "pixel_tools.h"

namespace talus {
namespace {

class ColorPicker : public PixelTool {
 public:
  void press(const PixelToolUse& use, Actions& actions) override {
    const std::uint8_t color =
        pixel_at(use.session.level(), use.session.choices().area, use.pixel.x, use.pixel.y);
    actions.push_back(action::SetColor{color, use.right});
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_color_picker() { return std::make_unique<ColorPicker>(); }

}  // namespace talus
