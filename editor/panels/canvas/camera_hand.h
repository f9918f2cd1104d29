// CameraHand: the wheel zooms a camera and drags move it, on the map, in the play view and on the sheet
// alike.
#pragma once

#include "camera.h"

namespace talus {

class Session;
struct Preferences;
struct View;

// Whether Space is held down for a drag that moves the view; false while Space steers a player, or presses
// the button of the keyboard's cursor.
bool space_moves_view(const Session& session, const View& view);

// Whether the middle button picks what is under the mouse in this frame: with a click that is no drag, or,
// where the user wants it as in TIC-80, as it goes down.
bool middle_button_picks(const Preferences& preferences);

class CameraHand {
 public:
  static constexpr int kNone = -1;
  bool is_moving() const { return button_ != kNone; }
  // Zooms by the wheel and keeps what lies at `at` in place, px from the canvas's corner. Returns whether it
  // zooms.
  bool zoom(Camera& camera, ImVec2 at);
  // Moves the view with the mouse until `button` is up, which went down on the canvas in this frame; kNone:
  // no button did. A click of the middle button moves nothing. Returns whether the view moves in this frame.
  bool move(Camera& camera, int button);

 private:
  float wheel_ = 0;  // clicks of the wheel that do not make a whole step yet: touch pads turn it by fractions
  int button_ = kNone;  // that moves the view
  ImVec2 last_;         // px of the screen: to where the view has moved with the mouse
};

}  // namespace talus
