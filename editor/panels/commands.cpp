// Looking commands up and running them.
#include "commands.h"

#include <algorithm>
#include <cassert>

#include "command_table.h"

namespace talus {
std::span<const Command> commands() {
  static const std::vector<Command> all =
      joined({general_commands(), program_commands(), debug_commands(), input_roll_commands(),
              tool_commands(), map_commands(), brush_commands(), curve_commands(), shape_commands(),
              flag_commands(), picture_commands(), problem_commands()});
  return all;
}

const Command& find_command(std::string_view id) {
  const auto all = commands();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.id == id; });
  assert(it != all.end());
  return *it;
}

CommandKeys command_keys(const Command& command, const KeyBindings& bindings) {
  const auto changed = bindings.changed.find(command.id);
  return changed == bindings.changed.end() ? CommandKeys{command.key, command.other_key} : changed->second;
}

std::string keys_of(const Command& command, const Ui& ui) {
  std::string keys;
  for (KeyChord chord : command_keys(command, ui.view.preferences.keys)) {
    if (chord) keys += (keys.empty() ? "" : ", ") + to_string(chord);
  }
  return keys;
}

std::string_view scope_label(Scope scope) {
  switch (scope) {
    case Scope::sprites:
      return "In the sprites";
    case Scope::map:
      return "In the map";
    case Scope::input:
      return "In the input roll";
    default:
      return "Everywhere";
  }
}

const Command& focus_command(Scope scope) {
  assert(scope != Scope::everywhere);
  return find_command(scope == Scope::sprites ? "view/sprites"
                      : scope == Scope::map   ? "view/map"
                                              : "view/input");
}

bool has_focus(const Command& command, const View& view) {
  switch (command.scope) {
    case Scope::sprites:
      return view.focus == Focus::sprites;
    case Scope::map:
      return view.focus == Focus::map;
    case Scope::input:
      return view.focus == Focus::input;
    default:
      return true;
  }
}

bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui) {
  for (const Command& command : commands()) {
    const CommandKeys keys = command_keys(command, ui.view.preferences.keys);
    if (chord != keys[0] && chord != keys[1]) continue;
    if (!has_focus(command, ui.view)) continue;
    if ((!repeated || command.repeats) && command.is_enabled(session, ui)) command.run(session, actions, ui);
    return true;
  }
  return false;
}

void command_button(std::string_view widget, std::string_view id, Icon icon, const Session& session,
                    Actions& actions, Ui& ui) {
  const Command& command = find_command(id);
  if (ui.icon_button(widget, icon, command.is_checked(session, ui), command.help, keys_of(command, ui),
                     command.is_enabled(session, ui)))
    command.run(session, actions, ui);
}

void command_text_button(std::string_view widget, std::string_view id, const Session& session,
                         Actions& actions, Ui& ui) {
  const Command& command = find_command(id);
  if (ui.text_button(widget, command.label, command.is_checked(session, ui), command.help,
                     keys_of(command, ui), command.is_enabled(session, ui)))
    command.run(session, actions, ui);
}

}  // namespace talus
