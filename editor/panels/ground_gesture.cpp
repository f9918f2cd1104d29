// The gesture of the ground tool.
#include "ground_gesture.h"

#include "canvas_layers.h"

namespace talus {

void ask_for_ground_tiles(Actions& actions, Ui& ui) {
  ui.view.wants_tab = "brushes";
  actions.push_back(action::ShowMessage{
      "The level has no tiles for ground yet: under Brushes, choose one for the inside, or propose them from "
      "the sheet.",
      true});
}

void GroundGesture::update(const Session& session, Actions& actions, Ui& ui, Cell cell, bool pressed,
                           bool down) {
  const Level& level = session.level();
  if (pressed && level.auto_tiles.of(GroundPart::inside) == 0) return ask_for_ground_tiles(actions, ui);
  if (pressed) {
    const ImGuiIO& io = ImGui::GetIO();
    from_ = last_ = cell;
    stroke_ = session.next_stroke();
    change_ = io.KeyCtrl ? GroundChange::remove : GroundChange::add;
    is_rectangle_ = io.KeyShift;
  }
  if (!from_) return;
  const auto push = [&](Edit edit) {
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke_});
  };
  if (down && !is_rectangle_ && (pressed || cell != last_)) push(paint_ground(level, last_, cell, change_));
  if (down) {
    last_ = cell;
    return;
  }
  if (is_rectangle_) push(fill_ground(level, spanned(*from_, last_), change_));
  from_.reset();
}

void GroundGesture::draw_preview(ImDrawList& list, const CanvasView& view, const Ui& ui, Cell cell) const {
  const bool removes = from_ ? change_ == GroundChange::remove : ImGui::GetIO().KeyCtrl;
  const CellRect cells = from_ && is_rectangle_ ? spanned(*from_, cell) : CellRect{cell.x, cell.y, 1, 1};
  draw_cell_frame(list, cells, view, theme::color(removes ? theme::kError : theme::kAccent), ui.px(1));
}

}  // namespace talus
