// The colour picker: takes the colour of the pixel under the press, for the button that was pressed.
#include "pixel_tools.h"

namespace talus {
namespace {

class ColorPicker : public PixelTool {
 public:
  void press(const PixelToolUse& use, Actions& actions) override {
    take_color(use.session, use.pixel, use.right, actions);
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_color_picker() { return std::make_unique<ColorPicker>(); }

}  // namespace talus
