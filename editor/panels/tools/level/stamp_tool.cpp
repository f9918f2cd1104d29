// The stamp tool: paints the selected tiles along the drag, or, at random, one of them in each cell.
#include "edit/brush_tools.h"
#include "edit/map_stroke.h"
#include "level_tools.h"
#include "panels/canvas/canvas_layers.h"
#include "selection_hint.h"

namespace talus {
namespace {

constexpr int kStampAlpha = 150;

// What one click paints.
Stamp stamp_at(const Session& session, Cell cell) {
  const Choices& choices = session.choices();
  if (!choices.random_stamp) return choices.stamp;
  return {1, 1, {random_tile(choices.stamp, cell, choices.random_seed, session.level().tile_notes)}};
}

CellRect stamped_cells(const Stamp& stamp, Cell cell) { return {cell.x, cell.y, stamp.w, stamp.h}; }

class StampTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    const Stamp stamp = stamp_at(use.session, use.cell);
    if (meets_selection(use.session, actions, stamped_cells(stamp, use.cell))) paint(use, actions);
    return true;
  }
  void drag(const LevelToolUse& use, Actions& actions) override {
    if (use.cell != use.last) paint(use, actions);
  }
  void draw(ImDrawList& list, const LevelToolUse& use) const override {
    if (!use.is_seen()) return;
    const Stamp stamp = stamp_at(use.session, use.cell);
    const CellRect cells = stamped_cells(stamp, use.cell);
    if (!use.from) draw_stamp(list, stamp, cells, use.view, use.ui, kStampAlpha);
    draw_cell_frame(list, cells, use.view, theme::color(theme::kText), use.ui.px(1));
  }

 private:
  static void paint(const LevelToolUse& use, Actions& actions) {
    const Level& level = use.session.level();
    const Choices& choices = use.session.choices();
    Edit edit = choices.random_stamp
                    ? paint_random_stroke(level, use.last, use.cell, choices.stamp, choices.random_seed,
                                          choices.selection)
                    : paint_stroke(level, *use.from, use.last, use.cell, choices.stamp, choices.selection);
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), use.stroke});
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_stamp_tool() { return std::make_unique<StampTool>(); }

}  // namespace talus
