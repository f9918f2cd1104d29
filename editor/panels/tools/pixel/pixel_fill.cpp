// The fill tool: fills the area of one colour at the press; with Ctrl replaces the colour everywhere.
#include "edit/sprite_fill.h"
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelFill : public PixelTool {
 public:
  void press(const PixelToolUse& use, Actions& actions) override {
    const Level& level = use.session.level();
    const SpriteArea& area = use.session.choices().area;
    actions.push_back(action::EditLevel{
        ImGui::GetIO().KeyCtrl
            ? replace_color(level, area, pixel_at(level, area, use.pixel.x, use.pixel.y), use.color())
            : fill_pixels(level, area, use.pixel, use.color())});
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_fill() { return std::make_unique<PixelFill>(); }

}  // namespace talus
