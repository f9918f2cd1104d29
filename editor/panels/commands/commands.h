// Commands: everything that has a key, in one table. The shortcuts, the menus, the tooltips, the help window
// and the command palette are all made from it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "keys.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Where a command's keys work. cursor: while the keyboard's cursor is shown, and before those of all others.
enum class Scope { everywhere, sprites, map, input, cursor };

struct Command {
  std::string_view id;     // "play/step", also the name of its widgets
  std::string_view label;  // in menus and the help: "Step one frame"
  std::string_view help;   // one sentence for the tooltip
  Scope scope = Scope::everywhere;
  KeyChord key, other_key;  // other_key: a second one, as other programs have it
  bool repeats = false;     // held down, it runs again and again
  void (*run)(const Session&, Actions&, Ui&) = nullptr;
  bool (*enabled)(const Session&, const Ui&) = nullptr;  // null: always
  bool (*checked)(const Session&, const Ui&) = nullptr;  // null: no switch
  bool any_modifiers = false;   // its keys work whether Ctrl, Shift and Alt are held or not
  std::string_view words = {};  // other words that the command palette finds it by, with blanks between

  bool is_enabled(const Session& session, const Ui& ui) const { return !enabled || enabled(session, ui); }
  bool is_checked(const Session& session, const Ui& ui) const { return checked && checked(session, ui); }
};

std::span<const Command> commands();
// The command must exist (asserted).
const Command& find_command(std::string_view id);
// Its keys as the user has them: those in the preferences, or else its own.
CommandKeys command_keys(const Command& command, const KeyBindings& bindings);
// "F5", or "Ctrl+Y, Ctrl+Shift+Z"; empty without a key.
std::string keys_of(const Command& command, const Ui& ui);
std::string_view scope_label(Scope scope);
// The command that gives the focus to where a scope's commands work; not of everywhere (asserted).
const Command& focus_command(Scope scope);
// Whether the command's keys work where the focus is.
bool has_focus(const Command& command, const View& view);

// Runs the command of a key, if there is one where the focus is. True when there was.
bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui);

// A button that runs a command and shows its state, help and keys.
void command_button(std::string_view widget, std::string_view command, Icon icon, const Session& session,
                    Actions& actions, Ui& ui);
// The same with the command's label.
void command_text_button(std::string_view widget, std::string_view command, const Session& session,
                         Actions& actions, Ui& ui);

}  // namespace talus
