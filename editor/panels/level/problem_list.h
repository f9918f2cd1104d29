// The list of problems, of one kind or all, and how to go from one to the next.
#pragma once

#include <string>
#include <vector>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// "3 problems" or "no problems"; while the level is still being checked, also "looking... 40 %".
std::string problems_text(const Session& session, const Ui& ui);

// How many problems a list shows.
inline constexpr std::size_t kMaxProblemRows = 500;

// Whether any problem is listed; cheaper than to ask for the rows, which are put in order.
bool lists_problems(const Ui& ui);
// Indices into Ui::problems of the listed ones: first those nearest to ProblemsView::near.
std::vector<std::size_t> listed_rows(const Ui& ui);
// Once a frame: notes where the followed body is paused or has stopped. The rows stay while the mouse is on
// them, and while the body moves.
void note_followed_body(const Session& session, bool is_list_hovered, ProblemsView& view);

// "(3,14)", for a narrow column.
std::string short_cell_text(Cell cell);
// Brings a cell into sight on the map, and gives the keys to the map.
void show_cell(Cell cell, View& view);
// Shows the place of a problem, and chooses the problem.
void go_to_problem(std::size_t index, const Session& session, Actions& actions, Ui& ui);
// Goes to the listed problem after the chosen one, or before it, around the ends of the list. If the chosen
// one is fixed, the problem that is in its row now is the next.
void go_to_next_problem(int direction, const Session& session, Actions& actions, Ui& ui);
// The chosen problem, if it still exists.
const Problem* chosen_problem(const Ui& ui);

// Applies a fix of a problem, by its index in fixes_for(), or the first one of all listed problems of its
// kind. A message says what was done, to how many, and what cannot be fixed.
void fix_problem(const Problem& problem, std::size_t choice, const Session& session, Actions& actions,
                 Ui& ui);
void fix_all_problems(const LintRule& rule, const Session& session, Actions& actions, const Ui& ui);

}  // namespace talus
