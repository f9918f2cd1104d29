// What the left button does on a canvas with the chosen map tool: from the press to the release.
#pragma once

#include <optional>

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

class MapGesture {
 public:
  // Call in every frame in which the mouse may act: `cell` is under it, `pressed` in the frame of the press,
  // `down` while it is held.
  void update(const Session& session, Actions& actions, Cell cell, bool pressed, bool down);
  // What a click here would do.
  void draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui,
                    Cell cell) const;
  bool active() const { return from_.has_value(); }

 private:
  void paint(const Session& session, Actions& actions, Cell cell);
  void finish(const Session& session, Actions& actions);

  std::optional<Cell> from_;  // where the button went down
  Cell last_;
  int stroke_ = 0;
};

}  // namespace talus
