// A row for each tuning field, by group.
#include "tuning_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "debug/number_text.h"
#include "edit/level_settings.h"
#include "panels/commands/commands.h"
#include "panels/ui/number_field.h"
#include "panels/ui/text_focus.h"

namespace talus {
namespace {

// "px/frame²"
std::string unit_of(const TuningField& field) {
  std::string unit(field.unit);
  if (unit.ends_with("^2")) unit.replace(unit.size() - 2, 2, "²");
  return unit;
}

std::string help_of(const TuningField& field) {
  if (!field.words.empty())
    return std::string(field.help) + "\nThe article has " + std::string(field.word_of(Tuning())) + ".";
  return std::string(field.help) + "\n" + (field.whole ? "A whole number from " : "From ") +
         exact_text(field.min) + " to " + exact_text(field.max) +
         (field.unit.empty() ? "" : " " + unit_of(field)) +
         (field.group.empty() ? "; the article has " : "; the default is ") + exact_text(field.standard()) +
         ".";
}

// A narrow column has no room for the unit, which the tooltip has.
std::string format_of(const TuningField& field, double value) {
  const std::string number = field.whole ? "%.0f" : "%.6g", unit = " " + unit_of(field);
  const float room = ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().FramePadding.x;
  return size_of_text(exact_text(value) + unit).x > room ? number : number + unit;
}

// The label of a choice, and the place of the choice beside it.
void draw_label(std::string_view label, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  ui.label(label);
  ImGui::SameLine(ui.px(56));
}

void draw_solver(const Session& session, Actions& actions, Ui& ui) {
  Tuning tuning = session.level().tuning;
  draw_label("Solver", ui);
  const bool open =
      ui.begin_combo("tuning/solver", std::string(solver_name(tuning.solver)), ui.px(120),
                     "Which solver moves the bodies: the article's own, with its defects; bump, "
                     "with slopes as one more response; or exact, the default.",
                     keys_of("tuning/solver"_command, ui));
  if (!open) return;
  for (const SolverKind solver : solver_kinds()) {
    const std::string name(solver_name(solver));
    if (selectable(name, {}, solver == session.level().tuning.solver)) {
      tuning.solver = solver;
      actions.push_back(action::EditLevel{set_tuning(session.level(), tuning)});
    }
    ui.item("tuning/solver_" + name);
  }
  ImGui::EndCombo();
}

// What is chosen by word.
void draw_choice(const TuningField& field, const Session& session, Actions& actions, Ui& ui) {
  const std::string item = "tuning/" + field.path();
  Tuning tuning = session.level().tuning;
  const std::string chosen(field.word_of(tuning));
  std::string label(field.label);
  label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  draw_label(label, ui);
  if (!ui.begin_combo(item, chosen, ui.px(120), help_of(field))) return;
  for (std::size_t i = 0; i < field.words.size(); ++i) {
    const std::string word(field.words[i]);
    if (selectable(word, {}, word == chosen)) {
      field.in(tuning) = static_cast<double>(i);
      if (tuning.shared.pairs() == BodyPairs::meet) tuning.solver = SolverKind::exact;  // no other has it
      actions.push_back(action::EditLevel{set_tuning(session.level(), tuning)});
    }
    ui.item(item + "_" + word);
  }
  ImGui::EndCombo();
}

// The solvers article and bump move players as balls; exact asks the ground itself instead of boxes.
bool is_used(const TuningField& field, SolverKind solver) {
  constexpr std::array<std::string_view, 4> kOfBoxes = {"cell_size", "slope_width", "slope_height",
                                                        "drag_probe"};
  if (solver != SolverKind::exact) return field.group.empty();
  return !field.group.empty() || std::find(kOfBoxes.begin(), kOfBoxes.end(), field.key) == kOfBoxes.end();
}

bool has_player(const Level& level) {
  return std::any_of(level.spawns.begin(), level.spawns.end(),
                     [](const Spawn& spawn) { return traits_of(spawn.kind).takes_keys; });
}

// What matters first: the numbers of players in a level that has one, and those that its solver does not use
// last.
std::vector<const TuningField*> ordered_fields(const Level& level) {
  std::vector<const TuningField*> fields;
  for (const TuningField& field : tuning_fields())
    if (field.words.empty()) fields.push_back(&field);
  const SolverKind solver = level.tuning.solver;
  const bool players_first = has_player(level);
  const auto rank = [&](const TuningField* field) {
    if (!is_used(*field, solver)) return 2;
    return players_first && field->group == "player" ? 0 : 1;
  };
  std::stable_sort(fields.begin(), fields.end(),
                   [&](const TuningField* a, const TuningField* b) { return rank(a) < rank(b); });
  return fields;
}

}  // namespace

void TuningPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_solver(session, actions, ui);
  for (const TuningField& field : tuning_fields())
    if (!field.words.empty()) draw_choice(field, session, actions, ui);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("tuning", 3, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ui.px(92));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ui.px(theme::kButton));
  const SolverKind solver = session.level().tuning.solver;
  std::string before;
  for (const TuningField* field : ordered_fields(session.level())) {
    std::string group(field->group.empty() ? "balls" : field->group);
    if (!is_used(*field, solver)) group = "not used by " + std::string(solver_name(solver));
    if (before != group) draw_group(group, ui);
    draw_field(*field, session, actions, ui);
    before = std::move(group);
  }
  ImGui::EndTable();
}

void TuningPanel::draw_group(std::string_view group, Ui& ui) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::TableNextColumn();
  ImGui::TablePushBackgroundChannel();  // it may be wider than the column of names
  ui.heading(group);
  ImGui::TablePopBackgroundChannel();
}

void TuningPanel::draw_field(const TuningField& field, const Session& session, Actions& actions, Ui& ui) {
  const std::string key = field.path();
  Tuning tuning = session.level().tuning;
  double& value = field.in(tuning);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const double standard = field.standard();
  const bool is_changed = value != standard;
  draw_text(field.label, theme::tone(is_changed ? theme::kWarning : theme::kText));
  ui.tooltip(help_of(field));
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  take_text_focus("tuning/" + key, ui);
  const double range = field.max - field.min;
  const std::string format = format_of(field, value);
  const bool changed =
      ImGui::DragScalar(("##" + key).c_str(), ImGuiDataType_Double, &value, static_cast<float>(range / 1000),
                        &field.min, &field.max, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  if (field.whole) value = std::round(value);
  if (ImGui::IsItemActivated()) stroke_ = session.next_stroke();
  ui.item("tuning/" + key, help_of(field), "drag, or double click to type; Tab: the next one");
  if (changed) actions.push_back(action::EditLevel{set_tuning(session.level(), tuning), stroke_});
  const bool resets = draw_number_menu("tuning/menu", value, standard, ui);
  ImGui::TableNextColumn();
  if (!is_changed) return;
  if (!resets && !ui.icon_button("tuning/reset_" + key, Icon::restart, false,
                                 "Back to " + exact_text(standard) + ".", {}))
    return;
  value = standard;
  actions.push_back(action::EditLevel{set_tuning(session.level(), tuning)});
}

}  // namespace talus
