// What the left button does on a canvas with the selection tool: selects cells, moves what is selected, and
// puts down what was pasted.
#pragma once

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

// Whether the left button is this gesture's.
inline bool selects(const Choices& choices) {
  return choices.map_tool == MapTool::select || choices.pasted.has_value();
}

class SelectGesture {
 public:
  // Call in every frame in which the mouse may act: `cell` is under it; `pressed` in the frame of the press,
  // `down` while it is held.
  void update(const Session& session, Actions& actions, Cell cell, bool pressed, bool down);
  // What a press here would do, or the size of what is dragged.
  void draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui,
                    Cell cell) const;
  bool active() const { return drag_ != Drag::none; }

 private:
  enum class Drag { none, select, move };

  void press(const Session& session, Actions& actions, Cell cell);
  void drag_on(const Session& session, Actions& actions, Cell cell);
  void release(Actions& actions) const;

  Drag drag_ = Drag::none;
  Cell from_;                   // where the button went down
  Cell grip_;                   // from the selection's corner to there
  bool moved_ = false;          // the mouse has left that cell since
  bool had_selection_ = false;  // when the button went down
  bool leaves_copy_ = false;
};

// The cells of the selection in dashes, dark and bright, so that they show on any art.
void draw_selection(ImDrawList& list, const CellRect& cells, const CanvasView& view, const Ui& ui);

}  // namespace talus
