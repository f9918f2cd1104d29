// Gamepads: those that are connected, and what is held on them.
#pragma once

#include <SDL2/SDL.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "panels/commands/pad_bindings.h"
#include "session/run/run_actions.h"

namespace talus {

class Gamepads {
 public:
  Gamepads() = default;
  ~Gamepads();
  Gamepads(const Gamepads&) = delete;
  Gamepads& operator=(const Gamepads&) = delete;

  // From now on gamepads that are connected, or will be, send events.
  void watch();
  // Follows an event. Returns true if it is one of a gamepad.
  bool follow(const SDL_Event& event);
  void release_all();
  action::HoldKeys held(const PadBindings& bindings) const;
  // The names of those that are connected.
  std::vector<std::string> names() const;
  // The name of the button that an event presses; nothing if it presses none.
  static std::optional<std::string> pressed_button(const SDL_Event& event);

 private:
  struct Pad {
    SDL_GameController* device = nullptr;  // null: it was never opened
    std::string name;
    std::set<std::string> down;  // buttons, by SDL's names
    double stick = 0;            // -1, left, to 1, right
  };
  bool is_down(const Pad& pad, const PadButtons& buttons) const;

  bool watches_ = false;
  std::map<SDL_JoystickID, Pad> pads_;
};

}  // namespace talus
