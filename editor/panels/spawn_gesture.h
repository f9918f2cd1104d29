// What the left button does on a canvas with the body tool: places a body, moves one that is there, or pulls
// the arrow of its velocity.
#pragma once

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

// The number of the chosen body's spawn; -1 when it has none or no body is chosen.
int chosen_spawn(const Session& session);

class SpawnGesture {
 public:
  // Call in every frame in which the mouse may act: it is at `at`, level px; `pressed` in the frame of the
  // press, `down` while it is held.
  void update(const Session& session, Actions& actions, const CanvasView& view, Vec2 at, bool pressed,
              bool down);
  // The arrow of the chosen body, whose tip is registered as "map/velocity_handle", its name, and, with the
  // mouse over the canvas, the name of the body under it.
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui, Vec2 at,
            bool hovered) const;
  bool active() const { return held_ >= 0; }

 private:
  void begin(const Session& session, Actions& actions, const CanvasView& view, Vec2 at);
  void move(const Session& session, Actions& actions, Vec2 at) const;
  void pull(const Session& session, Actions& actions, Vec2 at) const;

  int held_ = -1;       // index of the spawn that is held
  bool pulls_ = false;  // its arrow is held, not its box
  Vec2 grip_;           // px, from its corner, or from the arrow's tip, to the mouse
  int stroke_ = 0;
};

}  // namespace talus
