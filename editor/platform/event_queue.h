// EventQueue: hands out SDL's events frame by frame, as many as one frame can tell apart. Dear ImGui looks at
// keys and buttons once in a frame: it would see neither a press nor a release of the same frame. Typed text
// passes as it comes, so that slow frames do not make slow text. A drag goes on by one straight line in each
// frame, and its button goes up where it ends, so that a fast hand and a slow frame lose nothing of a stroke.
#pragma once

#include <SDL.h>

#include <array>
#include <bitset>
#include <deque>
#include <vector>

namespace talus {

// Place and buttons of the mouse, by the events alone, so that pushed events work like real ones.
struct MouseState {
  float x = 0, y = 0;   // px of the window
  bool inside = false;  // whether the mouse is over the window, or holds a button that was pressed there
  std::array<bool, 3> down = {};  // left, right, middle, as Dear ImGui numbers them
};

struct MousePlace {
  float x = 0, y = 0;  // px of the window
};

// Whether the user is there: a key, the mouse, a gamepad, a file that is dropped, or the window that is
// chosen. SDL also sends events of its own, such as that a sound device was found.
bool is_by_user(const SDL_Event& event);

class EventQueue {
 public:
  // Takes the waiting events. Call it once in a frame, before next(). hold_presses: presses and typed text
  // wait for a later frame; releases and movements do not.
  void begin_frame(bool hold_presses = false);
  // Returns the next event of this frame; false if the others must wait for the next frame.
  bool next(SDL_Event& event);
  bool empty() const { return waiting_.empty(); }
  const MouseState& mouse() const { return mouse_; }
  SDL_Keymod modifiers() const { return modifiers_; }

 private:
  bool must_wait(const SDL_Event& event) const;
  bool moved() const { return !passed_.empty(); }
  bool drags() const;  // whether a button is held
  bool turns(const SDL_Event& event) const;
  void track(const SDL_Event& event);
  void note_key(const SDL_Event& event);

  std::deque<SDL_Event> waiting_;
  MouseState mouse_;
  SDL_Keymod modifiers_ = KMOD_NONE;
  // For the current frame:
  bool holds_presses_ = false;
  MousePlace before_;               // the mouse at its beginning
  std::vector<MousePlace> passed_;  // the places that the mouse has passed since
  bool button_changed_ = false;
  bool typed_ = false;            // whether a text or any key was pressed
  bool command_pressed_ = false;  // whether a key was pressed that does not type
  std::bitset<SDL_NUM_SCANCODES> changed_keys_;
};

}  // namespace talus
