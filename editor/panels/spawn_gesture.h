// What the left button does on a canvas with the body tool: places a body, or moves one that is there.
#pragma once

#include "camera.h"
#include "session/session.h"

namespace talus {

// The number of the chosen body's spawn; -1 when it has none or no body is chosen.
int chosen_spawn(const Session& session);

class SpawnGesture {
 public:
  // Call in every frame in which the mouse may act: it is at `at`, level px; `pressed` in the frame of the
  // press, `down` while it is held.
  void update(const Session& session, Actions& actions, Vec2 at, bool pressed, bool down);
  bool active() const { return moved_ >= 0; }

 private:
  int moved_ = -1;  // index of the spawn that is held
  Vec2 grip_;       // px, from its corner to the mouse
  int stroke_ = 0;
};

}  // namespace talus
