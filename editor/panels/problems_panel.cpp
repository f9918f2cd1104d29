// The list of problems.
#include "problems_panel.h"

#include <algorithm>
#include <string>

namespace talus {
namespace {

constexpr std::size_t kMostRows = 500;

std::string place_of(const Problem& problem) {
  if (problem.cell)
    return "(" + std::to_string(problem.cell->x) + "," + std::to_string(problem.cell->y) + ")";
  return problem.tile >= 0 ? "#" + std::to_string(problem.tile) : "level";
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

void draw_problem(std::size_t row, const Problem& problem, const Session& session, Actions& actions, Ui& ui) {
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
  const float wrap = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::CalcTextSize(problem.message.c_str(), nullptr, false, wrap).y;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(problem.message.c_str());
  ImGui::PopTextWrapPos();
  ImGui::TableSetColumnIndex(0);
  const bool error = problem.severity == Severity::error;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::color(error ? theme::kError : theme::kWarning));
  const std::string label = place_of(problem) + "##" + std::to_string(row);
  if (ImGui::Selectable(label.c_str(), false, ImGuiSelectableFlags_SpanAllColumns, {0, height}))
    show_place(problem, session, actions, ui);
  ImGui::PopStyleColor();
  ui.item("problems/row" + std::to_string(row), problem.message + "\n" + problem.code, "click to go there");
}

}  // namespace

void ProblemsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto& problems = *ui.problems;
  if (problems.empty()) {
    ui.hint("No problem found in this level.");
    return;
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("problems", 2, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthFixed, ui.px(64));
  ImGui::TableSetupColumn("message", ImGuiTableColumnFlags_WidthStretch);
  for (std::size_t i = 0; i < std::min(problems.size(), kMostRows); ++i)
    draw_problem(i, problems[i], session, actions, ui);
  if (problems.size() > kMostRows) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    ui.hint("... and " + std::to_string(problems.size() - kMostRows) + " more.");
  }
  ImGui::EndTable();
}

}  // namespace talus
