// The state of the command palette and of the dialog for keys.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "keys.h"
#include "pad_bindings.h"

namespace talus {

// A key of a command that the user is about to press, or has pressed.
struct KeyCapture {
  std::string command;    // id
  std::size_t index = 0;  // 0 or 1: which of its two keys
  KeyChord pressed;       // empty: it waits, and gets every key that is pressed
};

struct CommandsView {
  bool palette_open = false;
  bool keys_open = false;
  std::optional<KeyCapture> key_capture;
  std::optional<PadCapture> pad_capture;
  std::vector<std::string> gamepads;  // names of those that are connected
};

}  // namespace talus
