// Spreads events over frames.
#include "event_queue.h"

#include <algorithm>

namespace talus {
namespace {

// Dear ImGui's number of a button; -1 for those without.
int button_index(Uint8 button) {
  switch (button) {
    case SDL_BUTTON_LEFT:
      return 0;
    case SDL_BUTTON_RIGHT:
      return 1;
    case SDL_BUTTON_MIDDLE:
      return 2;
    default:
      return -1;
  }
}

bool is_button(const SDL_Event& e) { return e.type == SDL_MOUSEBUTTONDOWN || e.type == SDL_MOUSEBUTTONUP; }
bool is_key(const SDL_Event& e) { return e.type == SDL_KEYDOWN || e.type == SDL_KEYUP; }

}  // namespace

void EventQueue::begin_frame() {
  SDL_Event event;
  while (SDL_PollEvent(&event)) waiting_.push_back(event);
  button_changed_ = key_changed_ = false;
}

bool EventQueue::next(SDL_Event& event) {
  if (waiting_.empty() || must_wait(waiting_.front())) return false;
  event = waiting_.front();
  waiting_.pop_front();
  track(event);
  return true;
}

// After a button changed, nothing more of the mouse in this frame: the change belongs to this place. After a
// key changed, no other change of a key.
bool EventQueue::must_wait(const SDL_Event& event) const {
  if (button_changed_)
    return is_button(event) || event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEWHEEL;
  return key_changed_ && is_key(event);
}

void EventQueue::track(const SDL_Event& event) {
  if (event.type == SDL_MOUSEMOTION) {
    mouse_.x = static_cast<float>(event.motion.x);
    mouse_.y = static_cast<float>(event.motion.y);
    mouse_.inside = true;
  } else if (is_button(event)) {
    button_changed_ = true;
    mouse_.x = static_cast<float>(event.button.x);
    mouse_.y = static_cast<float>(event.button.y);
    mouse_.inside = true;
    const int index = button_index(event.button.button);
    if (index >= 0) mouse_.down[static_cast<std::size_t>(index)] = event.type == SDL_MOUSEBUTTONDOWN;
  } else if (is_key(event)) {
    key_changed_ = true;
    modifiers_ = static_cast<SDL_Keymod>(event.key.keysym.mod);
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE) {
    mouse_.inside = std::find(mouse_.down.begin(), mouse_.down.end(), true) != mouse_.down.end();
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
    mouse_.down = {};  // their releases go to another window
    modifiers_ = KMOD_NONE;
  }
}

}  // namespace talus
