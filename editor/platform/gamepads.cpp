#include "gamepads.h"

#include <algorithm>

namespace talus {
namespace {

std::string name_of_button(Uint8 button) {
  const char* name = SDL_GameControllerGetStringForButton(static_cast<SDL_GameControllerButton>(button));
  return name != nullptr ? name : "";
}

}  // namespace

Gamepads::~Gamepads() {
  for (auto& [id, pad] : pads_)
    if (pad.device != nullptr) SDL_GameControllerClose(pad.device);
  if (watches_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void Gamepads::watch() {
  if (!watches_) watches_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
}

bool Gamepads::follow(const SDL_Event& event) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED: {
      SDL_GameController* device = SDL_GameControllerOpen(event.cdevice.which);
      if (device == nullptr) return true;
      const char* name = SDL_GameControllerName(device);
      const SDL_JoystickID id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(device));
      if (pads_[id].device != nullptr) SDL_GameControllerClose(pads_[id].device);  // it was announced twice
      pads_[id] = {device, name != nullptr ? name : "gamepad", {}, 0};
      return true;
    }
    case SDL_CONTROLLERDEVICEREMOVED: {
      const auto pad = pads_.find(event.cdevice.which);
      if (pad == pads_.end()) return true;
      if (pad->second.device != nullptr) SDL_GameControllerClose(pad->second.device);
      pads_.erase(pad);
      return true;
    }
    case SDL_CONTROLLERBUTTONDOWN:
      pads_[event.cbutton.which].down.insert(name_of_button(event.cbutton.button));
      return true;
    case SDL_CONTROLLERBUTTONUP:
      pads_[event.cbutton.which].down.erase(name_of_button(event.cbutton.button));
      return true;
    case SDL_CONTROLLERAXISMOTION:
      if (event.caxis.axis == SDL_CONTROLLER_AXIS_LEFTX)
        pads_[event.caxis.which].stick = std::max(-1.0, event.caxis.value / 32767.0);
      return true;
    default:
      return false;
  }
}

void Gamepads::release_all() {
  for (auto& [id, pad] : pads_) {
    pad.down.clear();
    pad.stick = 0;
  }
}

bool Gamepads::is_down(const Pad& pad, const PadButtons& buttons) const {
  return std::ranges::any_of(
      buttons, [&](const std::string& name) { return !name.empty() && pad.down.contains(name); });
}

action::HoldKeys Gamepads::held(const PadBindings& bindings) const {
  action::HoldKeys keys;
  for (const auto& [id, pad] : pads_) {
    const double stick = bindings.stick ? pad.stick : 0;
    keys.left = keys.left || is_down(pad, bindings.left) || stick < -bindings.dead_zone;
    keys.right = keys.right || is_down(pad, bindings.right) || stick > bindings.dead_zone;
    keys.jump = keys.jump || is_down(pad, bindings.jump);
  }
  return keys;
}

std::vector<std::string> Gamepads::names() const {
  std::vector<std::string> names;
  for (const auto& [id, pad] : pads_)
    if (pad.device != nullptr) names.push_back(pad.name);
  return names;
}

std::optional<std::string> Gamepads::pressed_button(const SDL_Event& event) {
  if (event.type != SDL_CONTROLLERBUTTONDOWN) return std::nullopt;
  return name_of_button(event.cbutton.button);
}

}  // namespace talus
