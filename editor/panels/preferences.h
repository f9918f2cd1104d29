// What the user has chosen about the program rather than about a level; remembered between starts
// (platform/settings.h).
#pragma once

#include <string>

#include "panels/commands/key_bindings.h"
#include "panels/commands/pad_bindings.h"
#include "panels/window/programs.h"

namespace talus {

enum class ThemeKind { dark, light };
// What is shown first without a file: the welcome page over the demo level, the file that was open last (the
// demo level if there is none), or the demo level.
enum class StartsWith { welcome, last_level, demo };

struct Preferences {
  ThemeKind theme = ThemeKind::dark;
  double font_size = 14;     // px at scale 1; kMinFontSize to kMaxFontSize
  bool plays_opened = true;  // whether a level with bodies plays as soon as it is open
  StartsWith starts_with = StartsWith::welcome;
  bool middle_picks = false;  // whether a press of the middle button picks, as in TIC-80; else a drag of it
                              // moves the view, and a click picks
  KeyBindings keys;
  PadBindings pad;
  ProgramCommands programs = default_program_commands();
  friend bool operator==(const Preferences&, const Preferences&) = default;
};
inline constexpr double kMinFontSize = 12, kMaxFontSize = 16;

}  // namespace talus
