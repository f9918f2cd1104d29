// KeyBindings: the keys that the user has given to commands instead of their default keys.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "keys.h"

namespace talus {

using CommandKeys = std::array<KeyChord, 2>;  // either may be empty

struct KeyBindings {
  std::map<std::string, CommandKeys, std::less<>>
      changed;  // by the command's id; an unknown id is kept, but not used

  friend bool operator==(const KeyBindings&, const KeyBindings&) = default;
};

}  // namespace talus
