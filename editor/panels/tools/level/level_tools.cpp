// The table of the level's tools.
#include "level_tools.h"

#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/drag_cancel.h"

namespace talus {

void LevelTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  if (use.is_seen())
    draw_cell_frame(list, {use.cell.x, use.cell.y, 1, 1}, use.view, theme::color(theme::kText), use.ui.px(1));
}

void LevelTool::cancel(const LevelToolUse& use, Actions& actions) {
  take_back(use.session, actions, use.stroke);
}

LevelToolHand::LevelToolHand() {
  tools_[MapTool::stamp] = make_stamp_tool();
  tools_[MapTool::select] = make_select_tool();
  tools_[MapTool::fill] = make_fill_tool();
  tools_[MapTool::line] = make_line_tool();
  tools_[MapTool::rectangle] = make_rectangle_tool();
  tools_[MapTool::ellipse] = make_ellipse_tool();
  tools_[MapTool::slope] = make_slope_tool();
  tools_[MapTool::segment] = make_curve_tool();
  tools_[MapTool::curve] = make_curve_tool();
  tools_[MapTool::body] = make_body_tool();
  tools_[MapTool::erase] = make_erase_tool();
  tools_[MapTool::pick] = make_pick_tool();
  tools_[MapTool::ground] = make_ground_tool();
  tools_[MapTool::flag] = make_flag_tool();
  tools_[MapTool::object] = make_object_tool();
}

// Pasted tiles belong to the selection tool, whichever tool is chosen.
LevelTool* LevelToolHand::chosen(const Choices& choices) const {
  const auto tool = tools_.find(choices.pasted ? MapTool::select : choices.map_tool);
  return tool == tools_.end() ? nullptr : tool->second.get();
}

void LevelToolHand::add_drag(LevelToolUse& use) const {
  use.from = from_;
  use.last = last_;
  use.stroke = stroke_;
}

void LevelToolHand::update(LevelToolUse use, Actions& actions, int pressed) {
  if (!active()) {
    LevelTool* const now = chosen(use.session.choices());
    if (resting_ != nullptr && resting_ != now) resting_->leave();
    resting_ = now;
    if (now != nullptr) now->rest(use, actions);
    if (pressed == kNoButton) return;
    LevelTool* tool = pressed == kMiddle ? tools_.at(MapTool::pick).get() : chosen(use.session.choices());
    if (tool == nullptr) return;
    button_ = pressed;
    from_ = last_ = use.cell;
    stroke_ = use.session.next_stroke();
    add_drag(use);
    if (!tool->press(use, actions)) return;
    held_ = tool;
    if (ImGui::GetIO().MouseDown[button_]) return;
    held_->release(use, actions);  // a click of the middle button is known as one when it is up
    held_ = nullptr;
    return;
  }
  add_drag(use);
  if (is_drag_cancelled()) {
    held_->cancel(use, actions);
    held_ = nullptr;
    return;
  }
  held_->drag(use, actions);
  last_ = use.cell;
  if (ImGui::GetIO().MouseDown[button_]) return;
  held_->release(use, actions);
  held_ = nullptr;
}

void LevelToolHand::draw(ImDrawList& list, LevelToolUse use) const {
  if (active()) add_drag(use);
  if (const LevelTool* tool = shown(use.session.choices())) tool->draw(list, use);
}

std::string LevelToolHand::hint(LevelToolUse use) const {
  if (active()) add_drag(use);
  const LevelTool* tool = shown(use.session.choices());
  return tool == nullptr ? std::string() : tool->hint(use);
}

}  // namespace talus
