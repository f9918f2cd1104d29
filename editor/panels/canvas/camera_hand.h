// CameraHand: the wheel zooms a camera and drags move it, on the map, in the play view and on the sheet
// alike.
#pragma once

#include "camera.h"

namespace talus {

class Session;
struct View;

// Whether Space is held down for a drag that moves the view; false while Space steers a player, or presses
// the button of the keyboard's cursor.
bool space_moves_view(const Session& session, const View& view);

class CameraHand {
 public:
  bool is_moving() const { return moving_; }
  // Zooms by the wheel and keeps what lies at `at` in place, px from the canvas's corner. Returns whether it
  // zooms.
  bool zoom(Camera& camera, ImVec2 at);
  // Moves the view with the mouse, from a frame with `starts` on until no button is down. Returns whether the
  // view moves in this frame.
  bool move(Camera& camera, bool starts);

 private:
  float wheel_ = 0;  // clicks of the wheel that do not make a whole step yet: touch pads turn it by fractions
  bool moving_ = false;
  ImVec2 last_;  // px of the screen: to where the view has moved with the mouse
};

}  // namespace talus
