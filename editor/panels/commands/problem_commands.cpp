// The commands of the problems, of proofs, and of the cells that a player can get to.
#include <algorithm>

#include "command_table.h"
#include "panels/level/problem_list.h"
#include "panels/level/proof_rows.h"
#include "session/checks/prover.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool has_problems(S, const Ui& ui) { return lists_problems(ui); }
bool has_chosen(S, const Ui& ui) { return chosen_problem(ui) != nullptr; }

bool is_way_at_mouse(S session, const Ui& ui) {
  const ReachFinder& reach = session.reach();
  return ui.view.canvas.hover.cell && reach.found() != nullptr && !reach.is_stale() &&
         reach.found()->reached(*ui.view.canvas.hover.cell);
}

void find_reach(S, A actions, U ui) {
  actions.push_back(action::FindReach{});
  ui.view.window.dock_open = true;
  ui.ask(request::ShowTab(panel_id::kReach));
}

void prove_level(S, A actions, U ui) {
  actions.push_back(action::Prove{ui.view.canvas.middle});
  ui.ask(request::ShowTab(panel_id::kProblems));
  ui.ask(request::ShowProof{});
  // In its own place the list of findings gets as much room as what is above it.
  constexpr double kLargestUpperPart = 0.5;
  WindowView& window = ui.view.window;
  if (std::ranges::find(window.moved_tabs, panel_id::kProblems, &MovedTab::panel) == window.moved_tabs.end())
    window.layout.right_split = std::min(window.layout.right_split, kLargestUpperPart);
}

}  // namespace

std::vector<Command> problem_commands() {
  return {
      {.id = "problems/next",
       .label = "Next problem",
       .help = "Shows the next problem of the list.",
       .key = KeyChord{kKeyF8},
       .menu = menus::kEditProblems,
       .run = [](S session, A actions, U ui) { go_to_next_problem(1, session, actions, ui); },
       .enabled = has_problems,
       .repeats = true},
      {.id = "problems/previous",
       .label = "Previous problem",
       .help = "Shows the previous problem of the list.",
       .key = shift(kKeyF8),
       .menu = menus::kEditProblems,
       .run = [](S session, A actions, U ui) { go_to_next_problem(-1, session, actions, ui); },
       .enabled = has_problems,
       .repeats = true},
      {.id = "problems/fix",
       .label = "Fix this problem",
       .help = "Does what the problem's Fix button says.",
       .key = alt(kKeyF8),
       .menu = menus::kEditProblems,
       .run = [](S session, A actions, U ui) { fix_problem(*chosen_problem(ui), 0, session, actions, ui); },
       .enabled = has_chosen},
      {.id = "problems/fix_kind",
       .label = "Fix all of this kind",
       .help = "Fixes every listed problem of the chosen one's kind, as one change that can be undone.",
       .key = alt_shift(kKeyF8),
       .menu = menus::kEditProblems,
       .run = [](S session, A actions,
                 U ui) { fix_all_problems(*chosen_problem(ui)->rule, session, actions, ui); },
       .enabled = has_chosen},
      {.id = "problems/prove",
       .label = "Prove the level",
       .help =
           "Lets the solver walk, jump and drop the bodies at every place of the level, first in view, and "
           "lists where one does what the ground does not explain. Later edits are proved, too, until it "
           "is stopped.",
       .menu = menus::kEditProblems,
       .run = prove_level,
       .words = "proof verify check stuck edge"},
      {.id = "problems/cancel_proof",
       .label = "Stop proving",
       .help = "Keeps what is found so far. Later edits are not proved.",
       .menu = menus::kEditProblems,
       .run = emit<action::CancelProof>,
       .enabled = [](S session, const Ui&) { return session.prover().follows_edits(); }},
      {.id = "problems/next_finding",
       .label = "Play the next finding of the proof",
       .help = "Goes to the place of the next finding, and plays it in a branch of its own.",
       .menu = menus::kEditProblems,
       .run = [](S session, A actions, U ui) { go_to_next_finding(session, actions, ui); },
       .enabled =
           [](S session, const Ui&) {
             const Proof* proof = session.prover().found();
             return proof != nullptr && !proof->findings.empty();
           }},
      {.id = "reach/find",
       .label = "Find where the player gets to",
       .help = "Lets the solver play every combination of keys from the player's start, and marks the cells "
               "that it gets to.",
       .key = KeyChord{kKeyF12},
       .menu = menus::kReach,
       .run = find_reach,
       .words = "reachable explore jump"},
      {.id = "reach/cancel",
       .label = "Stop finding where the player gets to",
       .help = "Keeps the cells that were found so far.",
       .key = shift(kKeyF12),
       .menu = menus::kReach,
       .run = emit<action::CancelReach>,
       .enabled = [](S session, const Ui&) { return session.reach().running(); }},
      {.id = "reach/show_way",
       .label = "Play the way to this cell",
       .help =
           "Plays how the player gets to the marked cell under the mouse, as a new branch of the timeline.",
       .key = KeyChord{'w'},
       .menu = menus::kReach,
       .run = [](S, A actions, U ui) { actions.push_back(action::ShowWay{*ui.view.canvas.hover.cell}); },
       .enabled = is_way_at_mouse},
  };
}

}  // namespace talus
