// The tiles that a shape reaches over, magnified, with handles on its line or its points to drag.
#pragma once

#include <optional>
#include <vector>

#include "edited_shape.h"
#include "panels/ui/ui.h"
#include "polygon_hand.h"
#include "session/session.h"

namespace talus {

class ShapeCanvas {
 public:
  // Draws the tiles in this room, px (very high ones reach below it), and handles the mouse. Returns the
  // edited part after a drag of its line; nothing while it does not change. A drag that starts on a handle
  // moves the handle by as much as the mouse; elsewhere it moves the line of a slope, or draws a profile
  // freely. Escape cancels it. The handles are registered as "shape/handle0" and so on. What the mouse does
  // to polygons is put into the level, or becomes a draft. tile: the one whose shape is shown.
  std::optional<TileShape> draw(const Session& session, Actions& actions, int tile, const EditedShape& edited,
                                ImVec2 room, Ui& ui);
  int stroke() const { return stroke_; }  // of the edits of a line's drag

 private:
  enum class Grip { none, handle, line, free };
  struct Frame;
  void take_hold(const Frame& frame, ImVec2 mouse);
  void drag(Frame& frame, Actions& actions);
  void move_held(Frame& frame, float y) const;
  void draw_freely(Frame& frame, ImVec2 mouse);
  bool chooses_part(const Frame& frame, Ui& ui) const;
  void follow_cursor(const Frame& frame, Ui& ui) const;
  void draw_shape(const Frame& frame, Ui& ui) const;
  void draw_line(const Frame& frame, Ui& ui) const;
  void draw_handles(const Frame& frame, const std::vector<ImVec2>& points, Ui& ui) const;

  PolygonHand hand_;
  int stroke_ = 0;
  Grip grip_ = Grip::none;
  int held_ = 0;              // index of the last height of the drag
  float from_y_ = 0;          // px of the screen, where the drag began
  std::vector<double> from_;  // the heights at that time
  int rows_ = 1;              // rows of tiles of the line; kept during a drag, as is `region_`
  Rect region_;               // px of the tile, what is shown: so that nothing jumps
};

}  // namespace talus
