// A row for every tuning field.
#include "tuning_panel.h"

#include <string>

namespace talus {
namespace {

std::string short_number(double value) {
  std::string text = std::to_string(value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string help_of(const TuningField& field) {
  const double standard = ArticleTuning{}.*field.value;
  return std::string(field.help) + "\nFrom " + short_number(field.min) + " to " + short_number(field.max) +
         (field.unit.empty() ? "" : " " + std::string(field.unit)) + "; the article has " +
         short_number(standard) + ".";
}

}  // namespace

void TuningPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  ui.heading("Solver: " + std::string(solver_name(session.level().tuning.solver)));
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("tuning", 4, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ui.px(92));
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, ui.px(60));
  ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ui.px(48));
  for (const TuningField& field : tuning_fields()) draw_field(field, session, actions, ui);
  ImGui::EndTable();
}

void TuningPanel::draw_field(const TuningField& field, const Session& session, Actions& actions, Ui& ui) {
  const std::string key(field.key);
  Tuning tuning = session.level().tuning;
  double& value = tuning.article.*field.value;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(field.label.data(), field.label.data() + field.label.size());
  ui.tooltip(help_of(field));
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  const double range = field.max - field.min;
  const bool changed =
      ImGui::DragScalar(("##" + key).c_str(), ImGuiDataType_Double, &value, static_cast<float>(range / 1000),
                        &field.min, &field.max, "%.6g", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemActivated()) stroke_ = session.next_stroke();
  ui.item("tuning/" + key, help_of(field), "drag, or double click to type");
  if (changed) actions.push_back(action::EditLevel{set_tuning(session.level(), tuning), stroke_});
  ImGui::TableNextColumn();
  ui.heading(field.unit);
  ImGui::TableNextColumn();
  const double standard = ArticleTuning{}.*field.value;
  if (session.level().tuning.article.*field.value == standard) return;
  if (ImGui::SmallButton(("reset##" + key).c_str())) {
    value = standard;
    actions.push_back(action::EditLevel{set_tuning(session.level(), tuning)});
  }
  ui.item("tuning/reset_" + key, "Back to " + short_number(standard) + ".");
}

}  // namespace talus
