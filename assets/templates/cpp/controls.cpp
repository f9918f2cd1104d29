// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "controls.h"

#include <algorithm>

namespace game {

void Controls::handle(const SDL_Event& event) {
  if (event.type == SDL_CONTROLLERDEVICEADDED)
    pads_.emplace_back(SDL_GameControllerOpen(event.cdevice.which), SDL_GameControllerClose);
  std::erase_if(pads_, [](const Pad& pad) { return !SDL_GameControllerGetAttached(pad.get()); });
}

talus::Input Controls::held(const Painter& painter) const {
  constexpr int kDeadZone = 32768 * 3 / 10;  // of the left stick, in which it is at rest
  const Uint8* keys = SDL_GetKeyboardState(nullptr);
  talus::Input input;
  input.left = keys[SDL_SCANCODE_LEFT] != 0 || keys[SDL_SCANCODE_A] != 0;
  input.right = keys[SDL_SCANCODE_RIGHT] != 0 || keys[SDL_SCANCODE_D] != 0;
  input.jump = keys[SDL_SCANCODE_UP] != 0 || keys[SDL_SCANCODE_W] != 0 || keys[SDL_SCANCODE_SPACE] != 0;
  for (const Pad& pad : pads_) {
    const auto is_down = [&](SDL_GameControllerButton button) {
      return SDL_GameControllerGetButton(pad.get(), button) != 0;
    };
    const int stick = SDL_GameControllerGetAxis(pad.get(), SDL_CONTROLLER_AXIS_LEFTX);
    input.left = input.left || is_down(SDL_CONTROLLER_BUTTON_DPAD_LEFT) || stick < -kDeadZone;
    input.right = input.right || is_down(SDL_CONTROLLER_BUTTON_DPAD_RIGHT) || stick > kDeadZone;
    input.jump = input.jump || is_down(SDL_CONTROLLER_BUTTON_A) || is_down(SDL_CONTROLLER_BUTTON_B);
  }
  int x = 0, y = 0;
  input.mouse_down = (SDL_GetMouseState(&x, &y) & SDL_BUTTON_LMASK) != 0;
  input.mouse = painter.on_map(x, y);
  return input;
}

}  // namespace game
