// Minimap: the whole map in a corner of a canvas, with a frame around what the canvas shows. A click goes
// there, and a drag moves along.
#pragma once

#include <optional>

#include <talus/level/level.h>
#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

class Minimap {
 public:
  // Returns true while the mouse acts on it, and so must not act on the canvas. `centre` is then the place to
  // show, in px of the level, if there is one. `hovered`: the mouse is on the canvas.
  bool update(const TileMap& map, const CanvasView& view, const Ui& ui, bool hovered,
              std::optional<Vec2>& centre);
  // `name`: of its widget.
  void draw(ImDrawList& list, const Level& level, const CanvasView& view, Ui& ui,
            std::string_view name) const;

 private:
  bool dragging_ = false;
};

}  // namespace talus
