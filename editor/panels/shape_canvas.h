// The tiles that a shape reaches over, magnified, with handles on its line to drag.
#pragma once

#include <optional>
#include <vector>

#include "session/session.h"
#include "ui.h"

namespace talus {

class ShapeCanvas {
 public:
  // Draws them in this room, px, and takes the mouse. The shape as it has just been dragged; nothing while it
  // stays. A drag starts with a press on a handle, or elsewhere: then it takes the nearer end of a slope, and
  // draws a profile freely. Its handles are registered as "shape/handle0" and on.
  std::optional<TileShape> draw(const Session& session, int tile, const TileShape& shape, ImVec2 room,
                                Ui& ui);
  int stroke() const { return stroke_; }  // of the drag's edits

 private:
  struct Frame;
  void drag(Frame& frame);
  void follow_cursor(const Frame& frame, Ui& ui) const;
  void draw_line(const Frame& frame, Ui& ui) const;
  void draw_handles(const Frame& frame, const std::vector<ImVec2>& points, Ui& ui) const;

  int stroke_ = 0;
  int held_ = -1;      // index of the height that is dragged; -1: none
  bool free_ = false;  // the drag passes from one height of a profile to the next
  int rows_ = 1;       // of tiles; kept during a drag, so that nothing jumps
};

}  // namespace talus
