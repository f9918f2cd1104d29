// What the left button does on a canvas with the slope tool: lays a slope along a line when it is released.
#pragma once

#include <optional>

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

class LineGesture {
 public:
  // Call in every frame in which the mouse may act: it is at `at`, level px; `pressed` in the frame of the
  // press, `down` while it is held. Ends of lines are on whole px.
  void update(const Session& session, Actions& actions, Vec2 at, bool pressed, bool down);
  // The line that a release at `at` would make, or where a press would begin one.
  void draw_preview(ImDrawList& list, const CanvasView& view, const Ui& ui, Vec2 at) const;
  bool active() const { return from_.has_value(); }

 private:
  void finish(const Session& session, Actions& actions, Vec2 to) const;

  std::optional<Vec2> from_;  // px, where the button went down
};

}  // namespace talus
