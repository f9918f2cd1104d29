// LevelTool: what a button of the mouse does on a canvas of the level, from the press to the release. Each
// tool is a file of this folder; level_tools.cpp has the table of them.
#pragma once

#include <optional>
#include <string>

#include "panels/canvas/camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Where the mouse is, and the drag that it is at.
struct LevelToolUse {
  const Session& session;
  Ui& ui;
  const CanvasView& view;
  Vec2 at;                        // level px, under the mouse
  Cell cell;                      // there
  bool hovered = false;           // the mouse is over the canvas
  std::optional<Cell> from = {};  // where the button went down; nothing: it is up
  Cell last = {};                 // where the drag had come to before this frame
  int stroke = 0;                 // of the drag's edits, so that they are one undo

  bool is_seen() const { return hovered || from; }
  CellRect dragged() const { return spanned(from.value_or(cell), cell); }
};

class LevelTool {
 public:
  virtual ~LevelTool() = default;
  // The button goes down. False: that was all, and no drag begins.
  virtual bool press(const LevelToolUse&, Actions&) { return true; }
  // In each frame after that, the one of the release included.
  virtual void drag(const LevelToolUse&, Actions&) {}
  // The button goes up, after drag().
  virtual void release(const LevelToolUse&, Actions&) {}
  // Escape ends the drag, instead of drag() and release(): all is as it was before the press. Takes back the
  // edits of its stroke.
  virtual void cancel(const LevelToolUse& use, Actions& actions);
  // What a press here would do, or the release of the button that is held: a frame around the cell.
  virtual void draw(ImDrawList& list, const LevelToolUse& use) const;
  // The same in words, for the foot of the canvas; empty: nothing to say.
  virtual std::string hint(const LevelToolUse&) const { return {}; }
};

}  // namespace talus
