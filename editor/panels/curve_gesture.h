// What the left button does on a canvas with the tools for segments and curves: draws a curve, chooses one
// and moves it, or drags one of its handles.
#pragma once

#include <optional>
#include <string>

#include "camera.h"
#include "edit/curve_tools.h"
#include "edit/snap.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

inline bool draws_curves(MapTool tool) { return tool == MapTool::segment || tool == MapTool::curve; }

// The chosen curve's index; -1: none, or it is gone.
int chosen_curve(const Session& session);
// What Delete does with these tools: takes away the curve under the mouse, else the chosen one.
void delete_curve(const Session& session, Actions& actions, const Ui& ui);

class CurveGesture {
 public:
  // Call in every frame in which the mouse may act: it is at `at`, level px; `pressed` in the frame of the
  // press, `down` while it is held.
  void update(const Session& session, Actions& actions, const CanvasView& view, Vec2 at, bool pressed,
              bool down);
  // The chosen curve with its handles, which are registered as "map/curve_handle0" and on, and, with the
  // mouse over the canvas, what a press would take or begin.
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui, Vec2 at,
            bool hovered) const;
  bool active() const { return drag_ != Drag::none; }

 private:
  enum class Drag { none, line, handle, whole };

  void begin(const Session& session, Actions& actions, const CanvasView& view, Vec2 at);
  void drag_on(const Session& session, Actions& actions, const CanvasView& view, Vec2 at);
  void finish(const Session& session, Actions& actions, const CanvasView& view, Vec2 at);
  void draw_new_line(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui,
                     Vec2 at) const;

  Drag drag_ = Drag::none;
  Vec2 from_;           // px, where a line begins, or where a curve or handle was taken
  bool moved_ = false;  // further than a shaking hand
  int curve_ = -1;      // index of the curve that is dragged
  int handle_ = -1;     // of that one
  LevelCurve before_;   // that curve, as it was
  int stroke_ = 0;
  std::string problem_;  // why the curve cannot be where the mouse is; empty: it can
};

}  // namespace talus
