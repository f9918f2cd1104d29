// The eraser: paints tile 0 along the drag.
#include "edit/map_stroke.h"
#include "level_tools.h"
#include "panels/canvas/canvas_layers.h"
#include "selection_hint.h"

namespace talus {
namespace {

class EraseTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    if (meets_selection(use.session, actions, use.dragged())) erase(use, actions);
    return true;
  }
  void drag(const LevelToolUse& use, Actions& actions) override {
    if (use.cell != use.last) erase(use, actions);
  }
  void draw(ImDrawList& list, const LevelToolUse& use) const override {
    if (use.is_seen())
      draw_cell_frame(list, {use.cell.x, use.cell.y, 1, 1}, use.view, theme::color(theme::kError),
                      use.ui.px(1));
  }

 private:
  static void erase(const LevelToolUse& use, Actions& actions) {
    Edit edit =
        paint_stroke(use.session.level(), *use.from, use.last, use.cell, {}, use.session.choices().selection);
    edit.label = "Erase tiles";
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), use.stroke});
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_erase_tool() { return std::make_unique<EraseTool>(); }

}  // namespace talus
