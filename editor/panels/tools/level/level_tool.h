// LevelTool: what a mouse button does on a canvas of the level, from the press to the release. Each tool is a
// file of this folder; level_tools.cpp has the table.
#pragma once

#include <optional>
#include <string>

#include "panels/canvas/camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// The place of the mouse, and the current drag.
struct LevelToolUse {
  const Session& session;
  Ui& ui;
  const CanvasView& view;
  Vec2 at;                        // level px, under the mouse
  Cell cell;                      // the cell there
  bool hovered = false;           // the mouse is over the canvas
  std::optional<Cell> from = {};  // where the button went down; nothing: it is up
  Cell last = {};                 // the drag's place before this frame
  int stroke = 0;                 // for the drag's edits, so that they are one undo

  bool is_seen() const { return hovered || from; }
  CellRect dragged() const { return spanned(from.value_or(cell), cell); }
};

class LevelTool {
 public:
  virtual ~LevelTool() = default;
  // The button goes down. Returns false if the press was the whole gesture, so that no drag begins.
  virtual bool press(const LevelToolUse&, Actions&) { return true; }
  // Called in each frame after that, also in the frame of the release.
  virtual void drag(const LevelToolUse&, Actions&) {}
  // The button goes up; called after drag().
  virtual void release(const LevelToolUse&, Actions&) {}
  // Called in each frame in which no button is held.
  virtual void rest(const LevelToolUse&, Actions&) {}
  // Another tool has been chosen.
  virtual void leave() {}
  // Escape ends the drag; called instead of drag() and release(). Undoes the edits of its stroke, so that
  // everything is as before the press.
  virtual void cancel(const LevelToolUse& use, Actions& actions);
  // Shows what a press here, or the release of the held button, would do: a frame around the cell.
  virtual void draw(ImDrawList& list, const LevelToolUse& use) const;
  // The same in words, for the foot of the canvas; empty if there is nothing to say.
  virtual std::string hint(const LevelToolUse&) const { return {}; }
};

}  // namespace talus
