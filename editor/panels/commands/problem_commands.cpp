// The commands of the problems, and of where a player gets to.
#include "command_table.h"
#include "panels/level/problem_list.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool has_problems(S, const Ui& ui) { return !listed_rows(ui).empty(); }
bool has_chosen(S, const Ui& ui) { return chosen_problem(ui) != nullptr; }

bool is_way_at_mouse(S session, const Ui& ui) {
  const ReachFinder& reach = session.reach();
  return ui.view.hover.cell && reach.found() != nullptr && !reach.is_stale() &&
         reach.found()->reached(*ui.view.hover.cell);
}

void find_reach(S, A actions, U ui) {
  actions.push_back(action::FindReach{});
  ui.view.dock_open = true;
  ui.view.wants_tab = "reach";
}

}  // namespace

std::vector<Command> problem_commands() {
  return {
      repeating(command(
          "problems/next", KeyChord{kKeyF8}, "Next problem", "Shows the next problem of those listed.",
          [](S session, A actions, U ui) { go_to_next_problem(1, session, actions, ui); }, has_problems)),
      repeating(command(
          "problems/previous", shift(kKeyF8), "Problem before", "Shows the problem before of those listed.",
          [](S session, A actions, U ui) { go_to_next_problem(-1, session, actions, ui); }, has_problems)),
      command(
          "problems/fix", alt(kKeyF8), "Fix this problem", "Does what the problem's Fix button says.",
          [](S session, A actions, U ui) { fix_problem(*chosen_problem(ui), session, actions); }, has_chosen),
      command(
          "problems/fix_kind", alt_shift(kKeyF8), "Fix all of this kind",
          "Fixes every listed problem of the chosen one's kind, as one change that can be undone.",
          [](S session, A actions, U ui) {
            fix_all_problems(chosen_problem(ui)->code, session, actions, ui);
          },
          has_chosen),
      also_called(
          "reachable explore jump",
          command(
              "reach/find", KeyChord{kKeyF12}, "Find where the player gets to",
              "Lets the solver play every combination of keys from the player's start, and marks the cells "
              "that it gets to.",
              find_reach)),
      command("reach/cancel", shift(kKeyF12), "Stop finding where the player gets to",
              "Keeps the cells that were found so far.", emit<action::CancelReach>,
              [](S session, const Ui&) { return session.reach().running(); }),
      command(
          "reach/show_way", KeyChord{'w'}, "Play the way to this cell",
          "Plays how the player gets to the marked cell under the mouse, as a new branch of the timeline.",
          [](S, A actions, U ui) { actions.push_back(action::ShowWay{*ui.view.hover.cell}); },
          is_way_at_mouse),
  };
}

}  // namespace talus
