// The tile sheet over a corner of the map while Shift is held, as in TIC-80, to choose a stamp.
#pragma once

#include <optional>

#include "camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Whether the tool paints the tiles that are chosen on the sheet.
bool paints_with_stamp(MapTool tool);

class SheetOverlay {
 public:
  // Call it in every frame before the tools. `hovered`: the mouse is over the canvas; `busy`: it drags
  // something else. Returns true if the mouse is on the sheet, and so not meant for anything else.
  bool update(const Session& session, Actions& actions, Ui& ui, const CanvasView& view, bool hovered,
              bool busy);
  // Registers it as "map/sheet".
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui) const;
  bool has_mouse() const { return has_mouse_; }

 private:
  bool shown_ = false;
  bool has_mouse_ = false;
  std::optional<Cell> from_;  // the tile where a drag began
};

}  // namespace talus
