// What the user has chosen about the program rather than about a level, and what the dialogs about it are
// doing. The preferences are remembered between starts (platform/settings.h).
#pragma once

#include <optional>
#include <string>

#include "panels/commands/key_bindings.h"
#include "panels/window/frame_metrics.h"
#include "panels/window/programs.h"

namespace talus {

enum class ThemeKind { dark, light };

struct Preferences {
  ThemeKind theme = ThemeKind::dark;
  double font_size = 14;  // px at scale 1; kMinFontSize to kMaxFontSize
  KeyBindings keys;
  ProgramCommands programs = default_program_commands();
  friend bool operator==(const Preferences&, const Preferences&) = default;
};
inline constexpr double kMinFontSize = 12, kMaxFontSize = 16;

// A command's key that waits to be pressed, or was.
struct KeyCapture {
  std::string command;    // id
  std::size_t index = 0;  // 0 or 1, of its two keys
  KeyChord pressed;       // none yet: it waits, and every key goes here
};

struct ProgramView {
  bool settings_open = false;
  bool keys_open = false;
  bool metrics_open = false;
  bool recovery_open = false;  // the dialog of what was saved by itself before a crash
  // Why unsaved work is not saved by itself at present: "the file cannot be written: No space left on
  // device"; empty: it is.
  std::string autosave_problem;
  std::optional<KeyCapture> key_capture;
  KeyChord dialog_key;  // that went down in this frame while a dialog was open, not by repetition
  std::optional<ProgramId> wanted_program;  // that is to open the level; taken by the next frame
  FrameMetrics metrics;
};

}  // namespace talus
