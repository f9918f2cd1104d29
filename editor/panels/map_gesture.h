// What the mouse does on a canvas with the chosen map tool: from the press to the release.
#pragma once

#include <optional>

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

class MapGesture {
 public:
  // Call in every frame in which the mouse may act: `cell` is under it. pressed: its button that went down on
  // the canvas in this frame: 0, 2 (the middle one, which picks tiles with any tool), or kNoButton.
  void update(const Session& session, Actions& actions, Cell cell, int pressed);
  // What a click here would do, or the release of the button that is down.
  void draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui,
                    Cell cell) const;
  bool active() const { return from_.has_value(); }

  static constexpr int kNoButton = -1;

 private:
  void press(const Session& session, Actions& actions, Cell cell);
  void paint(const Session& session, Actions& actions, Cell cell) const;
  void finish(const Session& session, Actions& actions) const;

  std::optional<Cell> from_;  // where the button went down
  Cell last_;
  int button_ = 0;
  MapTool tool_ = MapTool::stamp;  // that was chosen then
  int stroke_ = 0;
};

}  // namespace talus
