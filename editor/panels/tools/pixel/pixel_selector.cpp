// The selection tool: selects pixels, or moves the selected ones.
#include "pixel_tools.h"

namespace talus {
namespace {

class PixelSelector : public PixelTool {
 public:
  void press(const PixelToolUse& use, Actions&) override {
    const auto& selected = use.session.choices().pixels.rect();
    moves_ = selected && selected->contains(use.pixel);
    deselects_ = selected && !moves_;
  }
  void drag(const PixelToolUse& use, Actions& actions) override {
    deselects_ = false;
    if (moves_)
      actions.push_back(action::MovePixels{{use.pixel.x - use.last.x, use.pixel.y - use.last.y}});
    else
      actions.push_back(action::SelectPixels{spanned(use.from, use.pixel)});
  }
  // A click selects one pixel or, beside a selection, clears the selection.
  void release(const PixelToolUse& use, Actions& actions) override {
    if (moves_ || use.pixel != use.from) return;
    actions.push_back(action::SelectPixels{
        deselects_ ? std::optional<CellRect>() : std::optional<CellRect>({use.pixel.x, use.pixel.y, 1, 1})});
  }

 private:
  bool moves_ = false;      // whether it moves the selected pixels
  bool deselects_ = false;  // whether it clears the selection, if it does not move
};

}  // namespace

std::unique_ptr<PixelTool> make_pixel_selector() { return std::make_unique<PixelSelector>(); }

}  // namespace talus
