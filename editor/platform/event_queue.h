// EventQueue: hands SDL's events out frame by frame, as many as one frame can tell apart. Dear ImGui looks at
// keys and buttons once a frame: of a press and a release in the same frame it would see neither. Typing goes
// through as it comes, so that slow frames do not make slow text. A drag goes on by one straight line a
// frame, and its button goes up where it ends, so that a fast hand and a slow frame lose nothing of a stroke.
#pragma once

#include <SDL.h>

#include <array>
#include <bitset>
#include <deque>
#include <vector>

namespace talus {

// Where the mouse is and which buttons are down, by the events alone, so that pushed events work like real
// ones.
struct MouseState {
  float x = 0, y = 0;             // px of the window
  bool inside = false;            // the mouse is over the window, or holds a button that was pressed there
  std::array<bool, 3> down = {};  // left, right, middle, as Dear ImGui numbers them
};

struct MousePlace {
  float x = 0, y = 0;  // px of the window
};

class EventQueue {
 public:
  // Takes the events that wait. Call once a frame, before next(). hold_presses: what would be pressed or
  // typed now waits for a later frame; releases and movements do not.
  void begin_frame(bool hold_presses = false);
  // The next event of this frame; false when the rest must wait for the next one.
  bool next(SDL_Event& event);
  bool empty() const { return waiting_.empty(); }
  const MouseState& mouse() const { return mouse_; }
  SDL_Keymod modifiers() const { return modifiers_; }

 private:
  bool must_wait(const SDL_Event& event) const;
  bool moved() const { return !passed_.empty(); }
  bool drags() const;  // a button is held
  bool turns(const SDL_Event& event) const;
  void track(const SDL_Event& event);
  void note_key(const SDL_Event& event);

  std::deque<SDL_Event> waiting_;
  MouseState mouse_;
  SDL_Keymod modifiers_ = KMOD_NONE;
  // Of this frame:
  bool holds_presses_ = false;
  MousePlace before_;               // of the mouse, when it began
  std::vector<MousePlace> passed_;  // places to which the mouse has moved since
  bool button_changed_ = false;
  bool typed_ = false;            // a text or any key was pressed
  bool command_pressed_ = false;  // a key that is no typing
  std::bitset<SDL_NUM_SCANCODES> changed_keys_;
};

}  // namespace talus
