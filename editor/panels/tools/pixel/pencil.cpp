// The pencil: draws along the drag.
#include "pixel_tools.h"

namespace talus {
namespace {

class Pencil : public PixelTool {
 public:
  void press(const PixelToolUse& use, Actions& actions) override { draw_on(use, actions); }
  void drag(const PixelToolUse& use, Actions& actions) override { draw_on(use, actions); }
  bool uses_brush() const override { return true; }

 private:
  static void draw_on(const PixelToolUse& use, Actions& actions) {
    const Choices& choices = use.session.choices();
    actions.push_back(action::EditLevel{
        draw_line(use.session.level(), choices.area, use.last, use.pixel, {use.color(), choices.brush}),
        use.stroke});
  }
};

}  // namespace

std::unique_ptr<PixelTool> make_pencil() { return std::make_unique<Pencil>(); }

}  // namespace talus
