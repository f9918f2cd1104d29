// Spreads events over frames.
#include "event_queue.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr float kStraight = 1;           // px: a place so near to a line counts as on it
constexpr std::size_t kMaxWaiting = 64;  // events; with more of them a drag cuts corners to keep up

// Dear ImGui's number of a button; -1 for others.
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

float distance_to_line(MousePlace p, MousePlace from, MousePlace to) {
  const float dx = to.x - from.x, dy = to.y - from.y, length2 = dx * dx + dy * dy;
  const float along = (p.x - from.x) * dx + (p.y - from.y) * dy;
  const float part = length2 > 0 ? std::clamp(along / length2, 0.0f, 1.0f) : 0;
  return std::hypot(from.x + part * dx - p.x, from.y + part * dy - p.y);
}

bool is_button(const SDL_Event& e) { return e.type == SDL_MOUSEBUTTONDOWN || e.type == SDL_MOUSEBUTTONUP; }
bool is_mouse(const SDL_Event& e) {
  return is_button(e) || e.type == SDL_MOUSEMOTION || e.type == SDL_MOUSEWHEEL;
}
bool is_key(const SDL_Event& e) { return e.type == SDL_KEYDOWN || e.type == SDL_KEYUP; }
bool is_text(const SDL_Event& e) { return e.type == SDL_TEXTINPUT; }
bool is_press(const SDL_Event& e) {
  return e.type == SDL_MOUSEBUTTONDOWN || e.type == SDL_KEYDOWN || is_text(e);
}

bool is_modifier(SDL_Keycode key) { return key >= SDLK_LCTRL && key <= SDLK_RGUI; }

// A key that Dear ImGui looks at, unlike keys that only matter as text.
bool is_command_key(const SDL_Event& e) {
  if (!is_key(e) || is_modifier(e.key.keysym.sym)) return false;
  const SDL_Keysym& sym = e.key.keysym;
  const bool prints = sym.sym >= SDLK_SPACE && sym.sym != SDLK_DELETE && sym.sym < SDLK_CAPSLOCK;
  return !prints || (sym.mod & (KMOD_CTRL | KMOD_ALT)) != 0;
}

}  // namespace

bool is_by_user(const SDL_Event& event) {
  const bool is_pad = event.type == SDL_CONTROLLERBUTTONDOWN || event.type == SDL_CONTROLLERAXISMOTION;
  const bool is_chosen = event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_GAINED;
  return is_mouse(event) || is_key(event) || is_text(event) || is_pad || is_chosen ||
         event.type == SDL_DROPFILE;
}

void EventQueue::begin_frame(bool hold_presses) {
  SDL_Event event;
  while (SDL_PollEvent(&event)) waiting_.push_back(event);
  holds_presses_ = hold_presses;
  before_ = {mouse_.x, mouse_.y};
  passed_.clear();
  button_changed_ = typed_ = command_pressed_ = false;
  changed_keys_.reset();
}

bool EventQueue::next(SDL_Event& event) {
  if (waiting_.empty() || must_wait(waiting_.front())) return false;
  event = waiting_.front();
  waiting_.pop_front();
  track(event);
  return true;
}

// - After a button changed, nothing more of the mouse or the keyboard: the change belongs to this place, and
//   may give what is typed next another receiver.
// - After a command key, nothing more that is typed or clicked: Enter or Escape may close what would get it,
//   and a text field takes one such key a frame, after all letters.
// - After the mouse has moved, no key goes down and no button changes: they are meant for where the mouse has
//   come to, and a drag is made of the movements after its press, up to its release.
// - While a button is held, no movement round a corner: what is dragged gets every place.
// - After anything typed, no button: a click may take the text's field away before it has looked.
// - No key that counts changes twice.
bool EventQueue::must_wait(const SDL_Event& event) const {
  if (holds_presses_ && is_press(event)) return true;
  if (button_changed_) return is_mouse(event) || is_key(event) || is_text(event);
  if (command_pressed_) return is_button(event) || is_key(event) || is_text(event);
  if (typed_ && is_button(event)) return true;
  if (moved() && (event.type == SDL_KEYDOWN || is_button(event))) return true;
  if (drags() && turns(event)) return true;
  return is_command_key(event) && event.key.repeat == 0 && changed_keys_[event.key.keysym.scancode];
}

bool EventQueue::drags() const {
  return std::find(mouse_.down.begin(), mouse_.down.end(), true) != mouse_.down.end();
}

// Whether the straight line to the mouse's new place misses a place that it has passed in this frame.
bool EventQueue::turns(const SDL_Event& event) const {
  if (event.type != SDL_MOUSEMOTION || waiting_.size() > kMaxWaiting) return false;
  const MousePlace to{static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
  return std::any_of(passed_.begin(), passed_.end(),
                     [&](MousePlace place) { return distance_to_line(place, before_, to) > kStraight; });
}

void EventQueue::track(const SDL_Event& event) {
  if (event.type == SDL_MOUSEMOTION) {
    mouse_.x = static_cast<float>(event.motion.x);
    mouse_.y = static_cast<float>(event.motion.y);
    mouse_.inside = true;
    passed_.push_back({mouse_.x, mouse_.y});
  } else if (is_button(event)) {
    button_changed_ = true;
    mouse_.x = static_cast<float>(event.button.x);
    mouse_.y = static_cast<float>(event.button.y);
    mouse_.inside = true;
    const int index = button_index(event.button.button);
    if (index >= 0) mouse_.down[static_cast<std::size_t>(index)] = event.type == SDL_MOUSEBUTTONDOWN;
  } else if (is_key(event)) {
    note_key(event);
    modifiers_ = static_cast<SDL_Keymod>(event.key.keysym.mod);
  } else if (is_text(event)) {
    typed_ = true;
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE) {
    mouse_.inside = drags();
  } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
    mouse_.down = {};  // their releases go to another window
    modifiers_ = KMOD_NONE;
  }
}

void EventQueue::note_key(const SDL_Event& event) {
  if (event.key.repeat != 0 || is_modifier(event.key.keysym.sym)) return;
  changed_keys_.set(event.key.keysym.scancode);
  if (event.type != SDL_KEYDOWN) return;
  typed_ = true;
  command_pressed_ = command_pressed_ || is_command_key(event);
}

}  // namespace talus
