// EventQueue: hands SDL's events out frame by frame, so that none gets lost between two frames. Dear ImGui
// looks at the mouse once a frame: of a press and a release in the same frame it would see neither.
#pragma once

#include <SDL.h>

#include <array>
#include <deque>

namespace talus {

// Where the mouse is and which buttons are down, by the events alone, so that pushed events work like real
// ones.
struct MouseState {
  float x = 0, y = 0;             // px of the window
  bool inside = false;            // the mouse is over the window, or holds a button that was pressed there
  std::array<bool, 3> down = {};  // left, right, middle, as Dear ImGui numbers them
};

class EventQueue {
 public:
  // Takes the events that wait. Call once a frame, before next().
  void begin_frame();
  // The next event of this frame; false when the rest must wait for the next one.
  bool next(SDL_Event& event);
  bool empty() const { return waiting_.empty(); }
  const MouseState& mouse() const { return mouse_; }
  SDL_Keymod modifiers() const { return modifiers_; }

 private:
  bool must_wait(const SDL_Event& event) const;
  void track(const SDL_Event& event);

  std::deque<SDL_Event> waiting_;
  MouseState mouse_;
  SDL_Keymod modifiers_ = KMOD_NONE;
  bool button_changed_ = false;  // in this frame
  bool key_changed_ = false;
};

}  // namespace talus
