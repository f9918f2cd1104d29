// The problems as they are listed: those of one kind, or all, and going from one to the next.
#pragma once

#include <string>
#include <vector>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// "3 problems" or "no problems"; of a level that is still looked at "looking... 40 %", too.
std::string problems_text(const Session& session, const Ui& ui);

// Indices into Ui::problems of those that are listed.
std::vector<std::size_t> listed_rows(const Ui& ui);

// Shows where a problem is, and makes it the chosen one.
void go_to_problem(std::size_t index, const Session& session, Actions& actions, Ui& ui);
// The same with the listed one after the chosen one, or before it; round and round. Where the chosen one is
// fixed, the one that has its row now is the next.
void go_to_next_problem(int direction, const Session& session, Actions& actions, Ui& ui);
// The chosen one, if it is still there.
const Problem* chosen_problem(const Ui& ui);

// Applies the first fix of a problem, or of all that are listed of its kind. A message tells what was done to
// how many, and what cannot be fixed.
void fix_problem(const Problem& problem, const Session& session, Actions& actions);
void fix_all_problems(std::string_view code, const Session& session, Actions& actions, const Ui& ui);

}  // namespace talus
