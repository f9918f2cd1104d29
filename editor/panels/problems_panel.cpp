// The list of problems.
#include "problems_panel.h"

#include <string>

namespace talus {
namespace {

std::string place_of(const Problem& problem) {
  if (problem.cell)
    return "(" + std::to_string(problem.cell->x) + "," + std::to_string(problem.cell->y) + ")";
  return problem.tile >= 0 ? "#" + std::to_string(problem.tile) : "";
}

void show_place(const Problem& problem, const Session& session, Actions& actions, Ui& ui) {
  if (problem.cell) {
    ui.view.centre_on = ui.view.marked_cell = problem.cell;
    ui.view.focus = Focus::map;
    if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::both;
  } else if (problem.tile >= 0) {
    const CellRect tile{problem.tile % kSheetColumns, problem.tile / kSheetColumns, 1, 1};
    if (tile != session.choices().area.tiles) actions.push_back(action::SelectTiles{{SheetId::tiles, tile}});
  }
}

}  // namespace

void ProblemsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto& problems = session.problems();
  if (problems.empty()) {
    ui.hint("No problem found in this level.");
    return;
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("problems", 2, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthFixed, ui.px(64));
  ImGui::TableSetupColumn("message", ImGuiTableColumnFlags_WidthStretch);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(problems.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Problem& problem = problems[static_cast<std::size_t>(i)];
      const bool error = problem.severity == Severity::error;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushID(i);
      ImGui::PushStyleColor(ImGuiCol_Text, theme::color(error ? theme::kError : theme::kWarning));
      if (ImGui::Selectable(place_of(problem).c_str(), false, ImGuiSelectableFlags_SpanAllColumns))
        show_place(problem, session, actions, ui);
      ImGui::PopStyleColor();
      ui.item("problems/row" + std::to_string(i), problem.message + "\n" + problem.code, "click to go there");
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(problem.message.c_str());
      ImGui::PopID();
    }
  }
  ImGui::EndTable();
}

}  // namespace talus
