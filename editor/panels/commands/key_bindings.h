// KeyBindings: the keys that the user has given to commands, in place of their own.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "keys.h"

namespace talus {

using CommandKeys = std::array<KeyChord, 2>;  // either may be no key

struct KeyBindings {
  std::map<std::string, CommandKeys, std::less<>>
      changed;  // by the command's id; of no command: kept, unused

  friend bool operator==(const KeyBindings&, const KeyBindings&) = default;
};

}  // namespace talus
