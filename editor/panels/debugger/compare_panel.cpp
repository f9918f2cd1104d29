// What is compared with what, and how far each body is from the same body on the other side.
#include "compare_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "compare_choice.h"
#include "debug/compare.h"
#include "overlay/number_label.h"
#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"
#include "plot.h"

namespace talus {
namespace {

constexpr std::array<const char*, 6> kColumns = {"body", "apart px", "x", "y", "vx", "vy"};

void draw_cell(double value, Ui& ui) {
  ImGui::TableNextColumn();
  ui.right_aligned(std::isinf(value) ? "alone" : small_too(value));
  ui.tooltip(all_digits(value));
}

}  // namespace

void ComparePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_choice(session, actions, ui);
  if (!is_compared(session)) {
    ui.hint(
        "Choose what to compare with: the same input goes through both, and the other side is drawn as "
        "ghosts. To compare two branches, such as before and after an edit, see the list beside the "
        "timeline.");
    return;
  }
  draw_parting(session, actions, ui);
  if (session.other_state() != nullptr) return draw_bodies(session, actions, ui);
  draw_missing(session, actions, ui);
}

void ComparePanel::draw_choice(const Session& session, Actions& actions, Ui& ui) {
  ui.begin_row();
  ImGui::TextUnformatted("Compare with");
  ImGui::SameLine();
  const CompareChoice now = compare_choice(session);
  if (ui.begin_combo("compare/with", now.label, ui.px(170),
                     "What the shown branch is compared with. The key chooses the next one.",
                     keys_of("compare/next"_command, ui))) {
    for (const CompareChoice& choice : compare_choices(session)) {
      if (selectable(choice.label, {}, choice == now)) compare_with(choice, actions);
      ui.item("compare/" + choice.key);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  command_button("compare/split"_command, session, actions, ui);
  ui.end_row();
}

void ComparePanel::draw_parting(const Session& session, Actions& actions, Ui& ui) {
  ui.begin_row();
  ImGui::SameLine(0, ui.px(16));
  ImGui::TextUnformatted("apart by more than");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ui.px(64));
  double parting = session.debugger().parting();
  if (ImGui::InputDouble("##threshold", &parting, 0, 0, "%.6g"))
    actions.push_back(action::SetParting{parting});
  ui.item("compare/threshold", "Distance in px from which on bodies count as parted.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("px");
  ImGui::SameLine();
  command_text_button("compare/first"_command, session, actions, ui);
  ImGui::SameLine();
  command_text_button("compare/stop"_command, session, actions, ui);
  ui.end_row();
  if (const Series* series = session.debugger().parting_series())
    draw_timeline_plot("compare/plot",
                       "Distance in px of the chosen body from the same body on the other side. ", series,
                       theme::tone(theme::kError), ui.px(44), session, actions, ui);
}

void ComparePanel::draw_missing(const Session& session, Actions& actions, Ui& ui) {
  ui.begin_row();
  draw_text(missing_side(session) + ".");
  ui.item("compare/missing");
  ImGui::SameLine();
  if (session.debugger().comparing_progress(session.timeline()))
    command_text_button("timeline/cancel"_command, session, actions, ui, {.widget = "compare/cancel"});
  else if (ui.text_button("compare/end", "Show its last frame", false,
                          "Shows the last frame that both sides have."))
    actions.push_back(action::SeekFrame{session.debugger().other_end().value_or(0)});
  ui.end_row();
}

void ComparePanel::draw_bodies(const Session& session, Actions& actions, Ui& ui) {
  const auto bodies = differences(session.state(), *session.other_state());
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("bodies", 6, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (std::size_t i = 0; i < kColumns.size(); ++i)
    ImGui::TableSetupColumn(kColumns[i], ImGuiTableColumnFlags_WidthFixed, ui.px(i == 0 ? 56 : 84));
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const char* title : kColumns) {
    ImGui::TableNextColumn();
    if (title == kColumns[0]) {
      ui.heading(title);
    } else {
      ui.right_aligned(title, theme::tone(theme::kMuted));
    }
  }
  draw_rows(static_cast<int>(bodies.size()), [&](int row) {
    const BodyDifference& body = bodies[static_cast<std::size_t>(row)];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const int id = body.a != 0 ? body.a : body.b;
    if (selectable(std::to_string(id), {}, id == session.choices().body,
                   ImGuiSelectableFlags_SpanAllColumns) &&
        body.a != 0)
      actions.push_back(action::SelectBody{body.a});
    ui.item("compare/body" + std::to_string(id), body.a == 0   ? "Only on the other side."
                                                 : body.b == 0 ? "Only on this side."
                                                               : "Click to choose it.");
    draw_cell(body.distance, ui);
    draw_cell(body.position.x, ui);
    draw_cell(body.position.y, ui);
    draw_cell(body.velocity.x, ui);
    draw_cell(body.velocity.y, ui);
  });
  ImGui::EndTable();
}

}  // namespace talus
