// Commands: everything that a key, a menu or a button does, in one table with a row each (see
// command_table.h). The keys, the menus, the buttons, their tooltips, the help window and the command palette
// are made from it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "keys.h"
#include "menu_places.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Where a command's keys work. play: while they steer players, before those of the map. cursor: while the
// keyboard's cursor is shown, and before those of all others.
enum class Scope { everywhere, sprites, map, input, cursor, play };

using CommandRun = std::function<void(const Session&, Actions&, Ui&)>;
using CommandTest = std::function<bool(const Session&, const Ui&)>;

struct Command {
  std::string id = {};      // "play/step", also the name of its widgets; no two are the same
  std::string label = {};   // in menus and the help: "Step one frame"
  std::string help = {};    // one sentence for the tooltip
  KeyChord key = {};        // none: no key, until the user gives it one
  KeyChord other_key = {};  // a second one, as other programs have it
  Scope scope = Scope::everywhere;
  MenuPlace menu = {};             // one of menus::; none: in "All commands" alone
  Icon icon = Icon::none;          // of its button in a toolbar
  Icon checked_icon = Icon::none;  // in its place while it is on; none: the same one
  CommandRun run = {};             // never empty
  CommandTest enabled = {};        // empty: always
  CommandTest checked = {};        // empty: the command is no switch
  bool repeats = false;            // held down, its key runs it again and again
  bool any_modifiers = false;      // its keys work whether Ctrl, Shift and Alt are held or not
  // Of the scope play alone: what the players do while its key is down. Null in all other commands.
  bool action::HoldKeys::*holds = nullptr;
  std::string words = {};  // other words that the command palette finds it by, with blanks between

  bool is_enabled(const Session& session, const Ui& ui) const { return !enabled || enabled(session, ui); }
  bool is_checked(const Session& session, const Ui& ui) const { return checked && checked(session, ui); }
};

std::span<const Command> commands();
// The command must exist (asserted).
const Command& find_command(std::string_view id);
// Its keys as the user has them: those in the preferences, or else its own.
CommandKeys command_keys(const Command& command, const KeyBindings& bindings);
// "F5", or "Ctrl+Y, Ctrl+Shift+Z"; empty without a key.
std::string keys_of(const Command& command, const KeyBindings& bindings);
std::string keys_of(const Command& command, const Ui& ui);
std::string_view scope_label(Scope scope);
// The command that gives the focus to where a scope's commands work; not of everywhere (asserted).
const Command& focus_command(Scope scope);
// Whether the command's keys work where the focus is.
bool has_focus(const Command& command, const Session& session, const View& view);

// Runs the command of a key, if there is one where the focus is. True when there was. The keys of Scope::play
// are held instead: see HeldPlayKeys.
bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui);

// A button with the command's icon, which runs it and shows its state, help and keys. widget: the button's
// name; empty: the command's id.
void command_button(std::string_view id, const Session& session, Actions& actions, Ui& ui,
                    std::string_view widget = {});
// The same with a text. label: empty: the command's.
void command_text_button(std::string_view id, const Session& session, Actions& actions, Ui& ui,
                         std::string_view label = {}, std::string_view widget = {});

}  // namespace talus
