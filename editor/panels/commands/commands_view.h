// What the palette of commands and the dialog of their keys are doing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "keys.h"

namespace talus {

// A command's key that waits to be pressed, or was.
struct KeyCapture {
  std::string command;    // id
  std::size_t index = 0;  // 0 or 1, of its two keys
  KeyChord pressed;       // none yet: it waits, and every key goes here
};

struct CommandsView {
  bool palette_open = false;
  bool keys_open = false;
  std::optional<KeyCapture> key_capture;
};

}  // namespace talus
