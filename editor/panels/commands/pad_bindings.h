// The buttons of gamepads that steer the players.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace talus {

// Buttons by SDL's names for them: "a", "dpleft", "leftshoulder". A name that SDL does not know is never
// held.
using PadButtons = std::array<std::string, 2>;  // empty: none

struct PadBindings {
  PadButtons left{"dpleft", ""}, right{"dpright", ""}, jump{"a", "b"};
  bool stick = true;       // whether the left stick runs, too
  double dead_zone = 0.3;  // share of the stick's way, up to which it counts as at rest; 0.05 to 0.95
  friend bool operator==(const PadBindings&, const PadBindings&) = default;
};

// A button that the settings wait for.
struct PadCapture {
  PadButtons PadBindings::*buttons = &PadBindings::left;
  std::size_t index = 0;  // in *buttons
};

}  // namespace talus
