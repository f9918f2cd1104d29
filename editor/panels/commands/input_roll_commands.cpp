// The commands of the input roll. Its cursor is the shown frame, in one of its rows.
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

CommandRun go(int by) {
  return [by](S session, A actions, U ui) {
    ui.view.debugger.input_range.reset();
    actions.push_back(action::SeekFrame{session.state().frame + by});
  };
}

CommandRun extend(int by) {
  return [by](S session, A actions, U ui) {
    if (!ui.view.debugger.input_range) ui.view.debugger.input_range = session.state().frame;
    actions.push_back(action::SeekFrame{std::max<std::int64_t>(session.state().frame + by, 1)});
  };
}

CommandRun change_row(int by) {
  return [by](S, A, U ui) {
    const int last = static_cast<int>(kInputRows.size()) - 1;
    ui.view.debugger.input_row = std::clamp(ui.view.debugger.input_row + by, 0, last);
  };
}

void toggle_key(S session, A actions, U ui) {
  const InputKey key = kInputRows[static_cast<std::size_t>(ui.view.debugger.input_row)].key;
  Input now = session.timeline().current().input(session.state().frame);
  const FrameRange range = chosen_frames(session, ui.view);
  actions.push_back(action::SetInput{range.first, range.last, key, !key_in(now, key)});
}

void give_keys(S, A, U ui) {
  ui.view.window.dock_open = true;
  ui.ask(request::ShowTab(panel_id::kInputRoll));
  ui.view.window.focus = Focus::input;
}

}  // namespace

std::vector<Command> input_roll_commands() {
  return joined(
      {{{.id = "view/input",
         .label = "Input roll",
         .help = "Shows the keys and the mouse of every frame, and gives the keys to that strip.",
         .key = KeyChord{kKeyF6},
         .menu = menus::kDebugPanels,
         .run = give_keys,
         .checked = [](S, const Ui& ui) { return ui.view.window.focus == Focus::input; }}},
       in_scope(
           Scope::input,
           {
               {.id = "roll/back",
                .label = "Previous frame",
                .help = "Shows the previous frame.",
                .key = KeyChord{kKeyLeft},
                .run = go(-1),
                .enabled = has_input,
                .repeats = true},
               {.id = "roll/on",
                .label = "Next frame",
                .help = "Shows the next recorded frame.",
                .key = KeyChord{kKeyRight},
                .run = go(1),
                .enabled = has_next,
                .repeats = true},
               {.id = "roll/extend_back",
                .label = "Choose the previous frame, too",
                .help = "Makes the range longer, or shorter, and shows its end.",
                .key = shift(kKeyLeft),
                .run = extend(-1),
                .enabled = has_input,
                .repeats = true},
               {.id = "roll/extend_on",
                .label = "Choose the next frame, too",
                .help = "Makes the range longer, or shorter, and shows its end.",
                .key = shift(kKeyRight),
                .run = extend(1),
                .enabled = has_next,
                .repeats = true},
               {.id = "roll/up",
                .label = "Key above",
                .help = "Chooses another row.",
                .key = KeyChord{kKeyUp},
                .run = change_row(-1),
                .repeats = true},
               {.id = "roll/down",
                .label = "Key below",
                .help = "Chooses another row.",
                .key = KeyChord{kKeyDown},
                .run = change_row(1),
                .repeats = true},
               {.id = "roll/toggle",
                .label = "Press or release",
                .help =
                    "Presses or releases the chosen key in the chosen frames, and runs what follows again "
                    "from there.",
                .key = KeyChord{' '},
                .run = toggle_key,
                .enabled = has_input},
               {.id = "roll/mouse",
                .label = "Type the mouse's place",
                .help = "Goes to the field of the mouse's x; Tab goes on to its y.",
                .key = KeyChord{'m'},
                .run = [](S, A, U ui) { ui.ask(request::FocusField("input_roll/mouse_x")); },
                .enabled = has_input},
           })});
}

}  // namespace talus
