// Filters the problems, goes to them, and fixes them.
#include "problem_list.h"

#include "panels/panel_ids.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "level/level_text.h"
#include "level/lint/fixes.h"
#include "panels/canvas/opening_area.h"
#include "panels/commands/commands.h"
#include "proof_rows.h"

namespace talus {
namespace {

bool is_listed(const Problem& problem, const Ui& ui) {
  const LintRule* kind = ui.view.level.problems.kind;
  return kind == nullptr || problem.rule == kind;
}

// Problems without a place come last. Only as many as a list shows are in order.
void put_nearest_first(std::vector<std::size_t>& rows, const std::vector<Problem>& problems, Cell near) {
  const auto distance = [&](std::size_t row) {
    constexpr std::int64_t kNowhere = std::numeric_limits<std::int64_t>::max();
    const auto& cell = problems[row].cell;
    if (!cell) return kNowhere;
    const std::int64_t x = cell->x - near.x, y = cell->y - near.y;
    return x * x + y * y;
  };
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  order.reserve(rows.size());
  for (const std::size_t row : rows) order.emplace_back(distance(row), row);
  const auto sorted = static_cast<std::ptrdiff_t>(std::min(order.size(), kMaxProblemRows));
  std::partial_sort(order.begin(), order.begin() + sorted, order.end());
  std::transform(order.begin(), order.end(), rows.begin(), [](const auto& entry) { return entry.second; });
}

}  // namespace

std::string problems_text(const Session& session, const Ui& ui) {
  const std::size_t count = ui.problems->size(), findings = findings_of(session);
  std::string found = count == 0 && findings == 0 ? "no problems" : "";
  if (count > 0) found = count_text(count, "problem");
  if (findings > 0) found.append(count > 0 ? ", " : "").append(count_text(findings, "finding"));
  if (!session.is_linting()) return found;
  const std::string looking =
      "looking... " + std::to_string(static_cast<int>(session.lint_progress() * 100)) + " %";
  return count == 0 && findings == 0 ? looking : found + ", " + looking;
}

bool lists_problems(const Ui& ui) {
  return std::any_of(ui.problems->begin(), ui.problems->end(),
                     [&](const Problem& problem) { return is_listed(problem, ui); });
}

std::vector<std::size_t> listed_rows(const Ui& ui) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < ui.problems->size(); ++i)
    if (is_listed((*ui.problems)[i], ui)) rows.push_back(i);
  if (const auto near = ui.view.level.problems.near) put_nearest_first(rows, *ui.problems, *near);
  return rows;
}

void note_followed_body(const Session& session, bool is_list_hovered, ProblemsView& view) {
  constexpr int kFramesOfRest = 30;
  const Body* body = followed_body(session.state(), session.choices().body);
  if (body == nullptr) {
    if (!is_list_hovered) view.near.reset();
    return;
  }
  const Vec2 middle = body->box.center();
  const TileMap& map = session.level().map;
  const Cell cell = map.cell_at(middle);
  view.frames_there = cell == view.body_cell ? view.frames_there + 1 : 0;
  view.body_cell = cell;
  const bool rests = !session.playback().running || view.frames_there >= kFramesOfRest;
  if (!is_list_hovered && (!view.near || rests)) view.near = cell;
}

std::string short_cell_text(Cell cell) {
  return std::string("(").append(std::to_string(cell.x) + "," + std::to_string(cell.y) + ")");
}

void show_cell(Cell cell, View& view) {
  view.show_on_map(cell);
  view.window.focus = Focus::map;
}

void go_to_problem(std::size_t index, const Session& session, Actions& actions, Ui& ui) {
  const Problem& problem = (*ui.problems)[index];
  View& view = ui.view;
  view.level.problems.chosen = problem;
  view.requests.ask(request::ShowProblem{});
  const std::vector<std::size_t> rows = listed_rows(ui);
  view.level.problems.row =
      static_cast<std::size_t>(std::find(rows.begin(), rows.end(), index) - rows.begin());
  if (problem.cell) {
    show_cell(*problem.cell, view);
  } else if (problem.tile >= 0 && problem.tile < session.level().tile_count()) {
    const CellRect tile = ui.place_on_sheet(problem.tile);
    if (tile != session.choices().area.tiles) actions.push_back(action::SelectTiles{{SheetId::tiles, tile}});
  }
}

const Problem* chosen_problem(const Ui& ui) {
  const auto& chosen = ui.view.level.problems.chosen;
  const auto found =
      chosen ? std::find(ui.problems->begin(), ui.problems->end(), *chosen) : ui.problems->end();
  return found == ui.problems->end() ? nullptr : &*found;
}

void go_to_next_problem(int direction, const Session& session, Actions& actions, Ui& ui) {
  ui.ask(request::ShowTab(panel_id::kProblems));
  const std::vector<std::size_t> rows = listed_rows(ui);
  if (rows.empty()) return;
  const auto count = static_cast<std::ptrdiff_t>(rows.size());
  std::ptrdiff_t row = direction > 0 ? 0 : count - 1;
  const auto& chosen = ui.view.level.problems.chosen;
  const auto now = std::find_if(rows.begin(), rows.end(), [&](std::size_t index) {
    return chosen && (*ui.problems)[index] == *chosen;
  });
  if (now != rows.end()) {
    row = now - rows.begin() + direction;
  } else if (chosen) {
    row = static_cast<std::ptrdiff_t>(ui.view.level.problems.row) - (direction > 0 ? 0 : 1);
  }
  go_to_problem(rows[static_cast<std::size_t>((row % count + count) % count)], session, actions, ui);
}

void fix_problem(const Problem& problem, std::size_t choice, const Session& session, Actions& actions,
                 Ui& ui) {
  std::vector<Edit> fixes =
      fixes_for(session.level(), session.linted_level(), session.lint_options(), problem);
  if (choice < fixes.size()) {
    const std::string done =
        fixes[choice].label + ": done. " + keys_of("edit/undo"_command, ui) + " takes it back.";
    actions.push_back(action::EditLevel{std::move(fixes[choice])});
    actions.push_back(action::ShowMessage{done});
    ui.view.canvas.marked_cell.reset();
  } else {
    actions.push_back(action::ShowMessage{"There is no safe fix here: nothing was changed. " +
                                          std::string(problem.rule->by_hand)});
  }
}

void fix_all_problems(const LintRule& rule, const Session& session, Actions& actions, const Ui& ui) {
  int fixed = 0;
  Edit edit =
      fix_all(session.level(), session.linted_level(), session.lint_options(), *ui.problems, rule, &fixed);
  const auto all = std::count_if(ui.problems->begin(), ui.problems->end(),
                                 [&](const Problem& problem) { return problem.rule == &rule; });
  actions.push_back(action::EditLevel{std::move(edit)});
  actions.push_back(action::ShowMessage{"Fixed " + std::to_string(fixed) + " of " + std::to_string(all) +
                                        ": " + std::string(rule.label) + "."});
}

}  // namespace talus
