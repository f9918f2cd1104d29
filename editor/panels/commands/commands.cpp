// Finds and runs commands.
#include "commands.h"

#include <algorithm>
#include <cassert>

#include "command_table.h"
#include "panels/canvas/play_keys.h"

namespace talus {
namespace {

// How much a chord is meant for a command; 0: not at all. The cursor's commands come first, and then those
// that have just this chord: Alt+Enter is not Enter.
int answer(const Command& command, KeyChord chord, const KeyBindings& bindings) {
  const int of_cursor = command.scope == Scope::cursor ? 2 : 0;
  int best = 0;
  for (const KeyChord key : command_keys(command, bindings)) {
    if (!key) continue;
    if (key == chord) return of_cursor + 2;
    if (command.any_modifiers && key.key == chord.key) best = of_cursor + 1;
  }
  return best;
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> all = joined(
      {general_commands(),    player_commands(), cursor_commands(),  program_commands(), debug_commands(),
       input_roll_commands(), tool_commands(),   map_commands(),     layer_commands(),   brush_commands(),
       curve_commands(),      object_commands(), shape_commands(),   polygon_commands(), flag_commands(),
       picture_commands(),    export_commands(), problem_commands(), panel_commands(),   field_commands()});
  return all;
}

const Command& find_command(CommandId id) {
  const auto all = commands();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.id == id.text; });
  assert(it != all.end());
  return *it;
}

CommandKeys command_keys(const Command& command, const KeyBindings& bindings) {
  const auto changed = bindings.changed.find(command.id);
  return changed == bindings.changed.end() ? CommandKeys{command.key, command.other_key} : changed->second;
}

std::string keys_of(const Command& command, const KeyBindings& bindings) {
  std::string keys;
  for (KeyChord chord : command_keys(command, bindings)) {
    if (chord) keys += (keys.empty() ? "" : ", ") + to_string(chord);
  }
  return keys;
}

std::string keys_of(const Command& command, const Ui& ui) {
  return keys_of(command, ui.view.preferences.keys);
}

std::string keys_of(CommandId id, const Ui& ui) { return keys_of(find_command(id), ui); }

std::string_view scope_label(Scope scope) {
  switch (scope) {
    case Scope::sprites:
      return "In the sprites";
    case Scope::map:
      return "In the map";
    case Scope::shape:
      return "In the shape editor";
    case Scope::input:
      return "In the input roll";
    case Scope::cursor:
      return "At the keyboard's cursor";
    case Scope::play:
      return "In the play view";
    default:
      return "Everywhere";
  }
}

const Command& focus_command(Scope scope) {
  assert(scope != Scope::everywhere);
  return find_command(scope == Scope::sprites ? "view/sprites"_command
                      : scope == Scope::map   ? "view/map"_command
                      : scope == Scope::shape ? "view/shape"_command
                      : scope == Scope::input ? "view/input"_command
                      : scope == Scope::play  ? "play/toggle"_command
                                              : "view/cursor"_command);
}

bool has_focus(const Command& command, const Session& session, const View& view) {
  switch (command.scope) {
    case Scope::sprites:
      return view.window.focus == Focus::sprites;
    case Scope::map:
      return view.window.focus == Focus::map;
    case Scope::shape:
      return view.window.focus == Focus::shape;
    case Scope::input:
      return view.window.focus == Focus::input;
    case Scope::cursor:
      return view.canvas.cursor.on();
    case Scope::play:
      return keys_steer(session, view);
    default:
      return true;
  }
}

bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui) {
  const Command* found = nullptr;
  int best = 0;
  for (const Command& command : commands()) {
    if (command.scope == Scope::play) continue;
    const int its = answer(command, chord, ui.view.preferences.keys);
    if (its <= best || !has_focus(command, session, ui.view)) continue;
    found = &command;
    best = its;
  }
  if (found == nullptr) return false;
  ui.view.canvas.cursor.work_by(chord.key);
  if ((!repeated || found->repeats) && found->is_enabled(session, ui)) found->run(session, actions, ui);
  ui.view.canvas.cursor.work_by(kNoKey);
  return true;
}

void command_button(CommandId id, const Session& session, Actions& actions, Ui& ui, std::string_view widget) {
  const Command& command = find_command(id);
  const bool on = command.is_checked(session, ui);
  const Icon icon = on && command.checked_icon != Icon::none ? command.checked_icon : command.icon;
  if (ui.icon_button(widget.empty() ? id.text : widget, icon, on, command.help, keys_of(command, ui),
                     command.is_enabled(session, ui)))
    command.run(session, actions, ui);
}

void command_text_button(CommandId id, const Session& session, Actions& actions, Ui& ui,
                         const CommandButtonLook& look) {
  const Command& command = find_command(id);
  if (ui.text_button(look.widget.empty() ? id.text : look.widget,
                     look.label.empty() ? command.label : look.label, command.is_checked(session, ui),
                     command.help, keys_of(command, ui), look.enabled && command.is_enabled(session, ui),
                     look.width, look.height))
    command.run(session, actions, ui);
}

}  // namespace talus
