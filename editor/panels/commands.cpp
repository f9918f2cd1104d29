// Looking commands up and running them.
#include "commands.h"

#include <algorithm>
#include <cassert>

#include "command_table.h"

namespace talus {
std::span<const Command> commands() {
  static const std::vector<Command> all = joined({general_commands(), debug_commands(), tool_commands()});
  return all;
}

const Command& find_command(std::string_view id) {
  const auto all = commands();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.id == id; });
  assert(it != all.end());
  return *it;
}

std::string keys_of(const Command& command) {
  std::string keys = to_string(command.key);
  if (command.other_key) keys += ", " + to_string(command.other_key);
  return keys;
}

std::string_view scope_label(Scope scope) {
  switch (scope) {
    case Scope::sprites:
      return "In the sprites (F2)";
    case Scope::map:
      return "In the map (F3)";
    default:
      return "Everywhere";
  }
}

bool has_focus(const Command& command, const View& view) {
  return command.scope == Scope::everywhere ||
         (command.scope == Scope::sprites) == (view.focus == Focus::sprites);
}

bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui) {
  for (const Command& command : commands()) {
    if (chord != command.key && chord != command.other_key) continue;
    if (!has_focus(command, ui.view)) continue;
    if ((!repeated || command.repeats) && command.is_enabled(session, ui)) command.run(session, actions, ui);
    return true;
  }
  return false;
}

void command_button(std::string_view widget, std::string_view id, Icon icon, const Session& session,
                    Actions& actions, Ui& ui) {
  const Command& command = find_command(id);
  if (ui.icon_button(widget, icon, command.is_checked(session, ui), command.help, keys_of(command),
                     command.is_enabled(session, ui)))
    command.run(session, actions, ui);
}

}  // namespace talus
