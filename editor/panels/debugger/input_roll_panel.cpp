// The strip of keys around the shown frame.
#include "input_roll_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "input_roll.h"
#include "panels/commands/commands.h"
#include "panels/ui/text_focus.h"

namespace talus {
namespace {

constexpr float kColumn = 12, kRow = 18, kMaxRow = 36, kLabels = 56;  // px at scale 1
constexpr int kRulerStep = 10;                                        // frames
constexpr float kNumber = 72;                                         // px at scale 1, of a field

bool holds(const Branch& branch, std::int64_t frame, InputKey key) {
  Input input = branch.input(frame);
  return key_in(input, key);
}

}  // namespace

void InputRollPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (session.timeline().last_frame() == 0) {
    ui.hint(
        "Nothing was played yet. This strip shows what is held in each frame, and can change it: click a "
        "frame, or drag over several, and a new branch plays the new input.");
    command_text_button("play/toggle"_command, session, actions, ui,
                        {.label = "Play", .widget = "input_roll/play"});
    return;
  }
  const float column = ui.px(kColumn);
  const Columns view = visible_frames(session, ImGui::GetContentRegionAvail().x - ui.px(kLabels), column);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(2)));
  draw_ruler(session, actions, ui, view, column);
  const float gaps = ui.px(2) * static_cast<float>(kInputRows.size() + 1);
  const float room = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeight() - gaps;
  const float height =
      std::clamp(std::floor(room / static_cast<float>(kInputRows.size())), ui.px(kRow), ui.px(kMaxRow));
  for (int row = 0; row < static_cast<int>(kInputRows.size()); ++row)
    draw_row(row, session, ui, view, {column, height});
  ImGui::PopStyleVar();
  draw_mouse_place(session, actions, ui);
  if (stroke_ && !ImGui::IsMouseDown(0)) {
    actions.push_back(action::SetInput{std::min(stroke_->from, stroke_->to),
                                       std::max(stroke_->from, stroke_->to), stroke_->key, stroke_->on});
    stroke_.reset();
  }
}

// The shown frame stays at a third of the width, unless the wheel moved the strip.
InputRollPanel::Columns InputRollPanel::visible_frames(const Session& session, float width, float column) {
  Columns view{0, std::max(1, static_cast<int>(width / column))};
  const std::int64_t frame = session.state().frame;
  const float wheel = ImGui::IsWindowHovered() ? ImGui::GetIO().MouseWheel : 0;
  if (frame != scrolled_at_) scrolled_ = 0;
  scrolled_at_ = frame;
  if (wheel != 0) scrolled_ -= std::lround(wheel * 8);
  const std::int64_t most = std::max<std::int64_t>(session.timeline().last_frame() - view.count + 2, 1);
  view.first = std::clamp<std::int64_t>(frame - view.count / 3 + scrolled_, 1, most);
  scrolled_ = view.first - (frame - view.count / 3);
  return view;
}

void InputRollPanel::draw_ruler(const Session& session, Actions& actions, Ui& ui, Columns view,
                                float column) {
  ImGui::Dummy({ui.px(kLabels), ui.px(kRow)});
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("ruler", {column * static_cast<float>(view.count), ui.px(kRow)});
  ui.item("input_roll/ruler", "The frames that the input leads to; click to show one.",
          keys_of("roll/back"_command, ui) + "  " + keys_of("roll/on"_command, ui));
  if (ImGui::IsItemActivated()) take_keys(ui.view, ui.view.debugger.input_row);
  if (ImGui::IsItemActive()) {
    const auto i = static_cast<std::int64_t>((ImGui::GetIO().MousePos.x - at.x) / column);
    actions.push_back(action::SeekFrame{view.first + i});
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < view.count; ++i) {
    const std::int64_t frame = view.first + i;
    if (frame > session.timeline().last_frame()) break;
    const float x = at.x + column * static_cast<float>(i);
    if (frame == session.state().frame)
      list.AddRectFilled({x, at.y}, {x + column - 1, at.y + ui.px(kRow)}, theme::tone(theme::kAccent, 150));
    if (frame % kRulerStep != 0) continue;
    const std::string number = std::to_string(frame);
    const float end = at.x + column * static_cast<float>(view.count);
    add_text(list, {std::min(x, end - size_of_text(number).x), at.y}, theme::tone(theme::kMuted), number);
  }
}

void InputRollPanel::draw_row(int index, const Session& session, Ui& ui, Columns view, ImVec2 cell) {
  const auto [key, label] = kInputRows[static_cast<std::size_t>(index)];
  ImGui::PushID(index);
  const auto [column, height] = cell;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool has_keys = ui.view.window.focus == Focus::input && ui.view.debugger.input_row == index;
  const float above = std::floor((height - ImGui::GetTextLineHeight()) / 2);
  add_text(list, {start.x, start.y + above}, theme::tone(has_keys ? theme::kAccent : theme::kMuted), label);
  ImGui::Dummy({ui.px(kLabels), height});
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("row", {column * static_cast<float>(view.count), height});
  ui.item(
      "input_roll/" + std::string(label),
      "Click a frame to press or release the key; drag over several. What follows is run again from there.",
      keys_of("view/input"_command, ui) + ", arrows, " + keys_of("roll/toggle"_command, ui));
  if (ImGui::IsItemActivated()) take_keys(ui.view, index);
  handle_row(key, session, view, at, column);

  const Branch& branch = session.timeline().current();
  const FrameRange chosen = chosen_frames(session, ui.view);
  for (int i = 0; i < view.count; ++i) {
    const std::int64_t frame = view.first + i;
    if (frame > branch.last_frame()) break;
    bool on = holds(branch, frame, key);
    if (stroke_ && stroke_->key == key && frame >= std::min(stroke_->from, stroke_->to) &&
        frame <= std::max(stroke_->from, stroke_->to))
      on = stroke_->on;
    const float x = at.x + column * static_cast<float>(i);
    const ImVec2 from{x, at.y}, to{x + column - 1, at.y + height};
    list.AddRectFilled(from, to, theme::tone(on ? theme::kAccent : theme::kControl));
    if (frame == session.state().frame || (has_keys && chosen.has(frame)))
      list.AddRect(from, to, theme::tone(theme::kText), 0, 0, has_keys ? ui.px(2) : 1);
  }
  ImGui::PopID();
}

// The place of the mouse in the step to the shown frame, or in the steps of the range, which all get the
// typed place.
void InputRollPanel::draw_mouse_place(const Session& session, Actions& actions, Ui& ui) {
  const FrameRange chosen = chosen_frames(session, ui.view);
  if (session.state().frame < 1) return;  // a range may have begun at a later frame
  const Vec2 now = session.timeline().current().input(session.state().frame).mouse;
  ui.begin_row();
  const std::string first = std::to_string(chosen.first), last = std::to_string(chosen.last);
  draw_text(first == last ? "Mouse in frame " + first : "Mouse in frames " + first + " to " + last);
  const auto field = [&](const char* axis, double Vec2::*part) {
    const std::string name = std::string("input_roll/mouse_") + axis;
    ImGui::SameLine();
    draw_text(axis);
    ImGui::SameLine();
    if (edited_ != part) typed_.*part = now.*part;
    ImGui::SetNextItemWidth(ui.px(kNumber));
    take_text_focus(name, ui);
    ImGui::InputDouble(("##" + name).c_str(), &(typed_.*part), 0, 0, "%.2f");
    if (ImGui::IsItemActive()) edited_ = part;
    const bool entered = ImGui::IsItemDeactivatedAfterEdit();
    if (entered && std::isfinite(typed_.*part)) {
      Vec2 place = now;
      place.*part = typed_.*part;
      actions.push_back(action::SetMouse{chosen.first, chosen.last, place});
    }
    if (edited_ == part && !ImGui::IsItemActive()) edited_ = nullptr;
    ui.item(name,
            "Where the mouse was, px in the level; the play view shows the place. What is typed runs "
            "the recording again from there.",
            keys_of("roll/mouse"_command, ui));
  };
  field("x", &Vec2::x);
  field("y", &Vec2::y);
  ui.end_row();
}

void InputRollPanel::take_keys(View& view, int row) {
  view.window.focus = Focus::input;
  view.debugger.input_row = row;
  view.debugger.input_range.reset();
}

void InputRollPanel::handle_row(InputKey key, const Session& session, Columns view, ImVec2 at, float column) {
  const Branch& branch = session.timeline().current();
  const auto i = static_cast<std::int64_t>(std::floor((ImGui::GetIO().MousePos.x - at.x) / column));
  const std::int64_t frame = std::clamp<std::int64_t>(view.first + i, 1, branch.last_frame());
  if (ImGui::IsItemActivated()) stroke_ = Stroke{key, !holds(branch, frame, key), frame, frame};
  if (ImGui::IsItemActive() && stroke_) stroke_->to = frame;
}

}  // namespace talus
