// The list of stages. The one under the mouse, or else the chosen one, is drawn in the play view.
#include "why_panel.h"

#include <algorithm>
#include <cfloat>
#include <string>
#include <utility>

#include "debug/explain.h"
#include "panels/canvas/opening_area.h"
#include "panels/commands/body_hint.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr std::size_t kMaxStages = 500;  // most listed stages; each is wrapped anew in every frame

std::string_view title_of(StageKind kind) {
  switch (kind) {
    case StageKind::wanted:
      return "aim";
    case StageKind::searched:
      return "search";
    case StageKind::met:
      return "contact";
    case StageKind::placed:
      return "placing";
    case StageKind::went_on:
      return "way on";
    case StageKind::snapped:
      return "snap";
    case StageKind::arrived:
      return "end";
  }
  return {};
}

// A text that is already broken into lines.
void draw_lines(const std::string& text, ImU32 color) {
  ImGui::PushTextWrapPos(FLT_MAX);
  draw_text(text, color);
  ImGui::PopTextWrapPos();
}

float height_of(const std::string& lines) {
  if (lines.empty()) return 0;
  return static_cast<float>(1 + std::count(lines.begin(), lines.end(), '\n')) * ImGui::GetTextLineHeight();
}

}  // namespace

void WhyPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const int body = session.choices().body;
  if (session.state().find(body) == nullptr) {
    const Body* const player = followed_body(session.state(), 0);
    // Once, as the user may then choose none.
    if (player != nullptr && !std::exchange(ui.view.debugger.why_has_chosen, true))
      actions.push_back(action::SelectBody{player->id});
    draw_body_hint(" to see every stage of its step here", "why", session, actions, ui);
    return;
  }
  if (session.state().frame == 0) {
    ui.hint("No step yet: make one, and see here what happens in it.");
    command_text_button("play/step"_command, session, actions, ui, {.widget = "why/step"});
    return;
  }
  draw_wrapped_text(explain_step(session.frame_view(), body), theme::tone(theme::kText));
  command_text_button("why/last_stop"_command, session, actions, ui, {.widget = "why/last_stop"});
  ImGui::Spacing();
  command_button("why/before"_command, session, actions, ui);
  ImGui::SameLine();
  command_button("why/next"_command, session, actions, ui);
  ImGui::SameLine();
  const auto count = static_cast<int>(session.stages().size());
  ui.label(ui.view.debugger.stage < 0 || ui.view.debugger.stage >= count
               ? std::to_string(count) + " stages"
               : "stage " + std::to_string(ui.view.debugger.stage + 1) + " of " + std::to_string(count));
  draw_stages(session, ui);
}

void WhyPanel::draw_stages(const Session& session, Ui& ui) {
  ImGui::BeginChild("stages");
  const float indent = ui.px(64);
  const std::size_t count = std::min(session.stages().size(), kMaxStages);
  for (std::size_t i = 0; i < count; ++i) {
    const Stage& stage = session.stages()[i];
    const bool chosen = ui.view.debugger.stage == static_cast<int>(i);
    ImGui::PushID(static_cast<int>(i));
    const float width = ImGui::GetContentRegionAvail().x - indent;
    const std::string sentence = text_in_lines(stage.sentence, width),
                      numbers = text_in_lines(stage.numbers, width);
    const float height = std::max(height_of(sentence) + height_of(numbers), ImGui::GetTextLineHeight());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (chosen && shown_stage_ != ui.view.debugger.stage) ImGui::SetScrollHereY();
    if (ImGui::Selectable("##stage", chosen, ImGuiSelectableFlags_None, {0, height}))
      ui.view.debugger.stage = chosen ? -1 : static_cast<int>(i);
    if (ImGui::IsItemHovered()) {
      ui.view.debugger.pointed_stage = static_cast<int>(i);
      ui.view.debugger.pointed_in = ImGui::GetFrameCount();
    }
    ui.item("why/stage" + std::to_string(i), "The play view draws this stage. Click to keep it.");
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(at);
    ui.heading(title_of(stage.kind));
    ImGui::SetCursorScreenPos({at.x + indent, at.y});
    draw_lines(sentence, theme::tone(theme::kText));
    if (!numbers.empty()) {
      ImGui::SetCursorScreenPos({at.x + indent, at.y + height_of(sentence)});
      draw_lines(numbers, theme::tone(theme::kMuted));
    }
    ImGui::SetCursorScreenPos(next);
    ImGui::Dummy({0, 0});
    ImGui::PopID();
  }
  shown_stage_ = ui.view.debugger.stage;
  if (count < session.stages().size())
    ui.hint("... and " + std::to_string(session.stages().size() - count) + " more.");
  ImGui::EndChild();
}

}  // namespace talus
