// Commands: everything that a key, a menu or a button does is a row of one table (see command_table.h). The
// keys, the menus, the buttons, their tooltips, the help window and the command palette are made from this
// table.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "keys.h"
#include "menu_places.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Where the keys of a command work. play: while they steer players, before those of the map. cursor: while
// the keyboard's cursor is shown, before those of all other scopes.
enum class Scope { everywhere, sprites, map, shape, input, cursor, play };

using CommandRun = std::function<void(const Session&, Actions&, Ui&)>;
using CommandTest = std::function<bool(const Session&, const Ui&)>;

struct Command {
  std::string id = {};      // "play/step", also the name of its widgets; no two are the same
  std::string label = {};   // in menus and the help: "Step one frame"
  std::string help = {};    // one sentence for the tooltip
  KeyChord key = {};        // empty: no key unless the user chooses one
  KeyChord other_key = {};  // a second key, for habits from other programs
  Scope scope = Scope::everywhere;
  MenuPlace menu = {};             // one of menus::; none: in "All commands" alone
  Icon icon = Icon::none;          // of its button in a toolbar
  Icon checked_icon = Icon::none;  // replaces `icon` while the command is checked; none: `icon` stays
  CommandRun run = {};             // never empty
  CommandTest enabled = {};        // empty: always
  CommandTest checked = {};        // empty: the command is no switch
  bool repeats = false;            // its key repeats while it is held
  bool any_modifiers = false;      // its keys work with and without Ctrl, Shift and Alt
  // What the players do while the key is down. Only commands of the scope play have it; null in all others.
  bool action::HoldKeys::*holds = nullptr;
  std::string words = {};  // other words that the command palette finds it by, separated by blanks

  bool is_enabled(const Session& session, const Ui& ui) const { return !enabled || enabled(session, ui); }
  bool is_checked(const Session& session, const Ui& ui) const { return checked && checked(session, ui); }
};

// The id of a command where the program names it: "play/step"_command. CommandNames.* reads all of these
// names in the sources, and compares them with the table.
struct CommandId {
  std::string_view text;
  friend bool operator==(CommandId, CommandId) = default;
};
consteval CommandId operator""_command(const char* text, std::size_t length) { return {{text, length}}; }

std::span<const Command> commands();
// The command must exist (asserted).
const Command& find_command(CommandId id);
// The keys of a command: those in the preferences if it has some there, otherwise its default keys.
CommandKeys command_keys(const Command& command, const KeyBindings& bindings);
// "F5", or "Ctrl+Y, Ctrl+Shift+Z"; empty if it has no key.
std::string keys_of(const Command& command, const KeyBindings& bindings);
std::string keys_of(const Command& command, const Ui& ui);
std::string keys_of(CommandId id, const Ui& ui);
std::string_view scope_label(Scope scope);
// The command that gives the focus to the place of a scope. The scope must not be everywhere (asserted).
const Command& focus_command(Scope scope);
// Whether the focus is at a place where the command's keys work.
bool has_focus(const Command& command, const Session& session, const View& view);

// Runs the command of a key, if there is one at the focus. Returns whether there was one. The keys of
// Scope::play are held instead: see HeldPlayKeys.
bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui);

// Draws a button with the command's icon that runs it and shows its state, help and keys. widget: the
// button's name; empty: the command's id.
void command_button(CommandId id, const Session& session, Actions& actions, Ui& ui,
                    std::string_view widget = {});

struct CommandButtonLook {
  std::string_view label = {};   // empty: the command's label
  std::string_view widget = {};  // the button's name; empty: the command's id
  bool enabled = true;           // false: the button cannot be pressed, even if the command is enabled
  float width = 0;               // px of the screen; 0: fits the text
  float height = 0;              // px of the screen; 0: that of all buttons
};
// Draws a button with a text instead.
void command_text_button(CommandId id, const Session& session, Actions& actions, Ui& ui,
                         const CommandButtonLook& look = {});

}  // namespace talus
