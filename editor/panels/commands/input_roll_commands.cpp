// The commands of the input roll: its cursor is the shown frame, in one of its rows.
#include <algorithm>

#include "command_table.h"
#include "panels/debugger/input_roll.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool has_input(S session, const Ui&) { return session.state().frame > 0; }
bool has_next(S session, const Ui&) { return session.timeline().in_past(); }

template <int by>
void go(S session, A actions, U ui) {
  ui.view.input_range.reset();
  actions.push_back(action::SeekFrame{session.state().frame + by});
}

template <int by>
void extend(S session, A actions, U ui) {
  if (!ui.view.input_range) ui.view.input_range = session.state().frame;
  actions.push_back(action::SeekFrame{std::max<std::int64_t>(session.state().frame + by, 1)});
}

template <int by>
void change_row(S, A, U ui) {
  const int last = static_cast<int>(kInputRows.size()) - 1;
  ui.view.input_row = std::clamp(ui.view.input_row + by, 0, last);
}

void toggle_key(S session, A actions, U ui) {
  const InputKey key = kInputRows[static_cast<std::size_t>(ui.view.input_row)].key;
  Input now = session.timeline().current().input(session.state().frame);
  const FrameRange range = chosen_frames(session, ui.view);
  actions.push_back(action::SetInput{range.first, range.last, key, !key_in(now, key)});
}

void give_keys(S, A, U ui) {
  ui.view.dock_open = true;
  ui.view.wants_tab = "input_roll";
  ui.view.focus = Focus::input;
}

}  // namespace

std::vector<Command> input_roll_commands() {
  return joined(
      {{toggle("view/input", KeyChord{kKeyF6}, "Input roll",
               "Shows the keys and the mouse of every frame, and gives the keys to that strip.", give_keys,
               [](S, const Ui& ui) { return ui.view.focus == Focus::input; })},
       in_scope(
           Scope::input,
           {
               repeating(command("roll/back", KeyChord{kKeyLeft}, "Frame before", "Shows the frame before.",
                                 go<-1>, has_input)),
               repeating(command("roll/on", KeyChord{kKeyRight}, "Next frame",
                                 "Shows the next recorded frame.", go<1>, has_next)),
               repeating(command("roll/extend_back", shift(kKeyLeft), "Choose the frame before, too",
                                 "Makes the range longer, or shorter, and shows its end.", extend<-1>,
                                 has_input)),
               repeating(command("roll/extend_on", shift(kKeyRight), "Choose the next frame, too",
                                 "Makes the range longer, or shorter, and shows its end.", extend<1>,
                                 has_next)),
               repeating(
                   command("roll/up", KeyChord{kKeyUp}, "Key above", "Chooses another row.", change_row<-1>)),
               repeating(command("roll/down", KeyChord{kKeyDown}, "Key below", "Chooses another row.",
                                 change_row<1>)),
               command("roll/toggle", KeyChord{' '}, "Press or let go",
                       "Presses the chosen key in the chosen frames, or lets it go, and makes the run again "
                       "from there.",
                       toggle_key, has_input),
               command(
                   "roll/mouse", KeyChord{'m'}, "Type the mouse's place",
                   "Goes to the field of the mouse's x; Tab goes on to its y.",
                   [](S, A, U ui) { ui.view.wants_text = "input_roll/mouse_x"; }, has_input),
           })});
}

}  // namespace talus
