// The mouse on polygons in the shape editor: draws new ones, and moves, inserts and removes points.
#pragma once

#include <optional>
#include <vector>

#include "edited_shape.h"
#include "panels/canvas/camera.h"
#include "panels/ui/ui.h"

namespace talus {

class PolygonHand {
 public:
  // Handles the mouse on the canvas, which is ImGui's last item. A press on a point or beside a side takes
  // the point, or a new one; inside, it takes the polygon; on another part, it chooses that. While a polygon
  // is drawn, a press adds a point, and one on the first point closes it. A right click removes a point.
  // Escape cancels a drag. view: of px of the tile, whose top left is (0, 0).
  void update(const Session& session, Actions& actions, const CanvasView& view, Ui& ui);
  // Whether a drag goes on, under which nothing may jump.
  bool holds() const { return grip_ != Grip::none; }

  // The points and what a click would do; registered as "shape/point0" and so on.
  void draw(const Session& session, const CanvasView& view, Ui& ui) const;

 private:
  enum class Grip { none, point, whole, drawn };
  void press(const Session& session, Actions& actions, const CanvasView& view, Ui& ui);
  void press_drawing(const Session& session, Actions& actions, const CanvasView& view, Ui& ui);
  void take_hold(Grip grip, const EditedShape& edited, std::size_t point);
  void drag(const Session& session, Actions& actions, const CanvasView& view, Ui& ui);
  void cancel(const Session& session, Actions& actions, View& view);
  void remove_under_mouse(const Session& session, Actions& actions, const CanvasView& view, Ui& ui) const;
  void draw_drawing(const CanvasView& view, Ui& ui) const;
  void draw_polygon(const EditedShape& edited, const CanvasView& view, Ui& ui) const;

  Grip grip_ = Grip::none;
  bool moved_ = false;    // further than a click does
  int stroke_ = 0;        // of the drag's edits
  ImVec2 press_;          // px of the screen
  std::size_t held_ = 0;  // the point that is dragged, or by which the polygon is
  EditedShape from_;      // when the drag began
  TileShape polygon_;     // the edited part at that time, with an inserted point
};

}  // namespace talus
