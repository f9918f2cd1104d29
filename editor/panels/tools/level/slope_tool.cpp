// The slope tool: lays a slope of tiles along a line when the button is released. The ends snap to
// floors, to other slopes and to cells; with Alt they are on whole px of the map.
#include <cmath>

#include "edit/shape_tools.h"
#include "edit/snap.h"
#include "level_tools.h"
#include "panels/canvas/curve_drawing.h"
#include "selection_hint.h"

namespace talus {
namespace {

Vec2 slope_end_at(const LevelToolUse& use) {
  const Level& level = use.session.level();
  const Vec2 p = onto_map(level.map, use.at);
  if (ImGui::GetIO().KeyAlt) return {std::round(p.x), std::round(p.y)};
  return snap_slope_end(level, p, use.view.zoom);
}

class SlopeTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions&) override {
    from_ = slope_end_at(use);
    return true;
  }
  void release(const LevelToolUse& use, Actions& actions) override {
    const Choices& choices = use.session.choices();
    const CellRect cells = use.dragged();  // tiles may lie right beside the ends of the line
    if (!meets_selection(use.session, actions, {cells.x - 1, cells.y - 1, cells.w + 2, cells.h + 2})) return;
    const Vec2 to = slope_end_at(use);
    auto edit =
        lay_slope(use.session.level(), from_, to, choices.stamp, static_cast<std::uint8_t>(choices.color),
                  choices.selection, !ImGui::GetIO().KeyCtrl);
    if (!edit) {
      actions.push_back(action::ShowMessage{
          "Slope from " + position_text(from_) + " to " + position_text(to) + ": " + edit.error() + ".",
          true});
    } else if (!edit->empty()) {
      actions.push_back(action::EditLevel{*std::move(edit)});
    }
  }
  void draw(ImDrawList& list, const LevelToolUse& use) const override {
    if (!use.is_seen()) return;
    const ImVec2 to = use.view.to_screen(slope_end_at(use));
    const ImU32 dark = theme::color(theme::kDark, 200), bright = theme::color(theme::kAccent);
    const float width = use.ui.px(2), dot = use.ui.px(3);
    if (use.from) {
      const ImVec2 from = use.view.to_screen(from_);
      list.AddLine(from, to, dark, width + 2);
      list.AddLine(from, to, bright, width);
      list.AddCircleFilled(from, dot + 1, dark);
      list.AddCircleFilled(from, dot, bright);
    }
    list.AddCircleFilled(to, dot + 1, dark);
    list.AddCircleFilled(to, dot, bright);
  }

  std::string hint(const LevelToolUse& use) const override {
    if (!use.from) return {};
    return "Alt: no snapping. Ctrl: the ground below and above stays.";
  }

 private:
  Vec2 from_;  // px, where the button went down
};

}  // namespace

std::unique_ptr<LevelTool> make_slope_tool() { return std::make_unique<SlopeTool>(); }

}  // namespace talus
