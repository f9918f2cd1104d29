// The ground tool: paints ground; with Ctrl removes it; with Shift does so in a rectangle.
#include "edit/auto_tile.h"
#include "level_tools.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/ground_hint.h"
#include "selection_hint.h"

namespace talus {
namespace {

class GroundTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    if (use.session.level().auto_tiles.of(GroundPart::inside) == 0) {
      ask_for_ground_tiles(actions, use.ui);
      return false;
    }
    const ImGuiIO& io = ImGui::GetIO();
    change_ = io.KeyCtrl ? GroundChange::remove : GroundChange::add;
    is_rectangle_ = io.KeyShift;
    if (!is_rectangle_ && meets_selection(use.session, actions, use.dragged())) paint(use, actions);
    return true;
  }
  void drag(const LevelToolUse& use, Actions& actions) override {
    if (!is_rectangle_ && use.cell != use.last) paint(use, actions);
  }
  void release(const LevelToolUse& use, Actions& actions) override {
    if (!is_rectangle_ || !meets_selection(use.session, actions, use.dragged())) return;
    push(use, actions,
         fill_ground(use.session.level(), use.dragged(), change_, use.session.choices().selection));
  }
  void draw(ImDrawList& list, const LevelToolUse& use) const override {
    if (!use.is_seen()) return;
    const bool removes = use.from ? change_ == GroundChange::remove : ImGui::GetIO().KeyCtrl;
    const CellRect cells = use.from && is_rectangle_ ? use.dragged() : CellRect{use.cell.x, use.cell.y, 1, 1};
    draw_cell_frame(list, cells, use.view, theme::color(removes ? theme::kError : theme::kAccent),
                    use.ui.px(1));
  }

 private:
  void paint(const LevelToolUse& use, Actions& actions) const {
    push(use, actions,
         paint_ground(use.session.level(), use.last, use.cell, change_, use.session.choices().selection));
  }
  static void push(const LevelToolUse& use, Actions& actions, Edit edit) {
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), use.stroke});
  }

  GroundChange change_ = GroundChange::add;
  bool is_rectangle_ = false;
};

}  // namespace

std::unique_ptr<LevelTool> make_ground_tool() { return std::make_unique<GroundTool>(); }

}  // namespace talus
