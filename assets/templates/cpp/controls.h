// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// What is held for the players: on the keyboard, on gamepads and by the mouse.
#pragma once

#include <SDL.h>
#include <talus/sim/state.h>

#include <memory>
#include <vector>

#include "painter.h"

namespace game {

class Controls {
 public:
  void handle(const SDL_Event& event);  // opens gamepads that are plugged in
  talus::Input held(const Painter& painter) const;

 private:
  using Pad = std::unique_ptr<SDL_GameController, decltype(&SDL_GameControllerClose)>;
  std::vector<Pad> pads_;
};

}  // namespace game
