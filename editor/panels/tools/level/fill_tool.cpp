// The fill tool: fills the area of equal tiles at the press; with Ctrl replaces the tile everywhere.
#include "edit/map_fill.h"
#include "edit/map_replace.h"
#include "level_tools.h"
#include "selection_hint.h"

namespace talus {
namespace {

class FillTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    const Level& level = use.session.level();
    const Choices& choices = use.session.choices();
    const Cell cell = use.cell;
    if (!level.map.contains(cell) || !meets_selection(use.session, actions, use.dragged())) return true;
    Edit edit = ImGui::GetIO().KeyCtrl
                    ? replace_tile(level, level.map.tile_at(cell), cell, choices.stamp, choices.selection)
                    : flood_fill(level, cell, choices.stamp, choices.selection);
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), use.stroke});
    return true;
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_fill_tool() { return std::make_unique<FillTool>(); }

}  // namespace talus
