// The list of stages; the one that is chosen is drawn in the play view.
#include "why_panel.h"

#include <algorithm>
#include <string>

#include "commands.h"
#include "debug/explain.h"
#include "wrapped_text.h"

namespace talus {
namespace {

std::string_view title_of(StageKind kind) {
  switch (kind) {
    case StageKind::wanted:
      return "wants";
    case StageKind::searched:
      return "looks";
    case StageKind::met:
      return "meets";
    case StageKind::placed:
      return "is put";
    case StageKind::went_on:
      return "goes on";
    case StageKind::snapped:
      return "snaps";
    case StageKind::arrived:
      return "arrives";
  }
  return {};
}

// Broken into lines of up to `width` px.
std::string wrapped(const std::string& text, float width) {
  const auto fits = [width](std::string_view line) {
    return ImGui::CalcTextSize(line.data(), line.data() + line.size()).x <= width;
  };
  std::string lines;
  for (const std::string_view line : lines_between_words(text, fits))
    lines.append(lines.empty() ? "" : "\n").append(line);
  return lines;
}

void draw_text(const std::string& text, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void WhyPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const int body = session.choices().body;
  if (session.state().find(body) == nullptr) {
    ui.hint("No body chosen: click one in the play view, and every stage of its step is told here.");
    return;
  }
  if (session.state().frame == 0) {
    ui.hint("No step yet: F10 makes one, and what happened in it is told here.");
    return;
  }
  draw_text(wrapped(explain_step(session.frame_view(), body), ImGui::GetContentRegionAvail().x),
            theme::tone(theme::kText));
  ImGui::Spacing();
  command_button("why/before", "why/before", Icon::step_back, session, actions, ui);
  ImGui::SameLine();
  command_button("why/next", "why/next", Icon::step, session, actions, ui);
  ImGui::SameLine();
  const auto count = static_cast<int>(session.stages().size());
  ui.label(ui.view.stage < 0 || ui.view.stage >= count
               ? std::to_string(count) + " stages"
               : "stage " + std::to_string(ui.view.stage + 1) + " of " + std::to_string(count));
  draw_stages(session, ui);
}

void WhyPanel::draw_stages(const Session& session, Ui& ui) {
  ImGui::BeginChild("stages");
  const float indent = ui.px(64);
  for (std::size_t i = 0; i < session.stages().size(); ++i) {
    const Stage& stage = session.stages()[i];
    const bool chosen = ui.view.stage == static_cast<int>(i);
    ImGui::PushID(static_cast<int>(i));
    const float width = ImGui::GetContentRegionAvail().x - indent;
    const std::string sentence = wrapped(stage.sentence, width), numbers = wrapped(stage.numbers, width);
    const auto height_of = [](const std::string& text) {
      return text.empty() ? 0.0f : ImGui::CalcTextSize(text.c_str()).y;
    };
    const float height = std::max(height_of(sentence) + height_of(numbers), ImGui::GetTextLineHeight());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (chosen && shown_stage_ != ui.view.stage) ImGui::SetScrollHereY();
    if (ImGui::Selectable("##stage", chosen, ImGuiSelectableFlags_None, {0, height}))
      ui.view.stage = chosen ? -1 : static_cast<int>(i);
    ui.item("why/stage" + std::to_string(i), "Click to draw this stage in the play view.");
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(at);
    ui.heading(title_of(stage.kind));
    ImGui::SetCursorScreenPos({at.x + indent, at.y});
    draw_text(sentence, theme::tone(theme::kText));
    if (!numbers.empty()) {
      ImGui::SetCursorScreenPos({at.x + indent, at.y + height_of(sentence)});
      draw_text(numbers, theme::tone(theme::kMuted));
    }
    ImGui::SetCursorScreenPos(next);
    ImGui::Dummy({0, 0});
    ImGui::PopID();
  }
  shown_stage_ = ui.view.stage;
  ImGui::EndChild();
}

}  // namespace talus
