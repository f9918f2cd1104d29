// The strip of keys, around the frame that is shown.
#include "input_roll_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace talus {
namespace {

constexpr float kColumn = 12, kRow = 18, kLabels = 56;  // px at scale 1
constexpr int kRulerStep = 10;                          // frames

struct Row {
  InputKey key;
  std::string_view label;
};
constexpr std::array<Row, 4> kRows = {{{InputKey::left, "left"},
                                       {InputKey::right, "right"},
                                       {InputKey::jump, "jump"},
                                       {InputKey::mouse, "mouse"}}};

bool holds(const Branch& branch, std::int64_t frame, InputKey key) {
  Input input = branch.input(frame);
  return key_in(input, key);
}

}  // namespace

void InputRollPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (session.timeline().last_frame() == 0) {
    ui.hint(
        "Nothing played yet. What is held in each frame is shown here, and can be changed: press a key on a "
        "frame, or drag to hold it over several, and the run is made again with it.");
    return;
  }
  const float column = ui.px(kColumn);
  const View view = visible_frames(session, ImGui::GetContentRegionAvail().x - ui.px(kLabels), column);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(2)));
  draw_ruler(session, actions, ui, view, column);
  for (const Row& row : kRows) draw_row(row.key, row.label, session, ui, view, column);
  ImGui::PopStyleVar();
  if (stroke_ && !ImGui::IsMouseDown(0)) {
    actions.push_back(action::SetInput{std::min(stroke_->from, stroke_->to),
                                       std::max(stroke_->from, stroke_->to), stroke_->key, stroke_->on});
    stroke_.reset();
  }
}

// The frame that is shown stays at a third of the width, unless the wheel moved the strip.
InputRollPanel::View InputRollPanel::visible_frames(const Session& session, float width, float column) {
  View view{0, std::max(1, static_cast<int>(width / column))};
  const std::int64_t frame = session.state().frame;
  const float wheel = ImGui::IsWindowHovered() ? ImGui::GetIO().MouseWheel : 0;
  if (frame != scrolled_at_) scrolled_ = 0;
  scrolled_at_ = frame;
  if (wheel != 0) scrolled_ -= std::lround(wheel * 8);
  const std::int64_t most = std::max<std::int64_t>(session.timeline().last_frame() - view.columns + 2, 1);
  view.first = std::clamp<std::int64_t>(frame - view.columns / 3 + scrolled_, 1, most);
  scrolled_ = view.first - (frame - view.columns / 3);
  return view;
}

void InputRollPanel::draw_ruler(const Session& session, Actions& actions, Ui& ui, View view, float column) {
  ImGui::Dummy({ui.px(kLabels), ui.px(kRow)});
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("ruler", {column * static_cast<float>(view.columns), ui.px(kRow)});
  ui.item("input_roll/ruler", "The frames that the input leads to; click to show one.");
  if (ImGui::IsItemActive()) {
    const auto i = static_cast<std::int64_t>((ImGui::GetIO().MousePos.x - at.x) / column);
    actions.push_back(action::SeekFrame{view.first + i});
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < view.columns; ++i) {
    const std::int64_t frame = view.first + i;
    if (frame > session.timeline().last_frame()) break;
    const float x = at.x + column * static_cast<float>(i);
    if (frame == session.state().frame)
      list.AddRectFilled({x, at.y}, {x + column - 1, at.y + ui.px(kRow)}, theme::color(theme::kAccent, 150));
    if (frame % kRulerStep != 0) continue;
    list.AddText({x, at.y}, theme::color(theme::kMuted), std::to_string(frame).c_str());
  }
}

void InputRollPanel::draw_row(InputKey key, std::string_view label, const Session& session, Ui& ui, View view,
                              float column) {
  ImGui::PushID(static_cast<int>(key));
  const float height = ui.px(kRow);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(start, theme::color(theme::kMuted), label.data(), label.data() + label.size());
  ImGui::Dummy({ui.px(kLabels), height});
  ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("row", {column * static_cast<float>(view.columns), height});
  ui.item("input_roll/" + std::string(label),
          "Click a frame to press or let go; drag to hold over several. The run is made again from there.");
  handle_row(key, session, view, at, column);

  const Branch& branch = session.timeline().current();
  for (int i = 0; i < view.columns; ++i) {
    const std::int64_t frame = view.first + i;
    if (frame > branch.last_frame()) break;
    bool on = holds(branch, frame, key);
    if (stroke_ && stroke_->key == key && frame >= std::min(stroke_->from, stroke_->to) &&
        frame <= std::max(stroke_->from, stroke_->to))
      on = stroke_->on;
    const float x = at.x + column * static_cast<float>(i);
    list.AddRectFilled({x, at.y}, {x + column - 1, at.y + height},
                       on ? theme::color(theme::kAccent) : theme::color(theme::kControl));
    if (frame == session.state().frame)
      list.AddRect({x, at.y}, {x + column - 1, at.y + height}, theme::color(theme::kText));
  }
  ImGui::PopID();
}

void InputRollPanel::handle_row(InputKey key, const Session& session, View view, ImVec2 at, float column) {
  const Branch& branch = session.timeline().current();
  const auto i = static_cast<std::int64_t>(std::floor((ImGui::GetIO().MousePos.x - at.x) / column));
  const std::int64_t frame = std::clamp<std::int64_t>(view.first + i, 1, branch.last_frame());
  if (ImGui::IsItemActivated()) stroke_ = Stroke{key, !holds(branch, frame, key), frame, frame};
  if (ImGui::IsItemActive() && stroke_) stroke_->to = frame;
}

}  // namespace talus
