// Minimap: the whole map in a corner of a canvas, with a frame around what the canvas shows. A click goes
// there, and a drag moves along.
#pragma once

#include <optional>

#include <talus/level/tile_map.h>
#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

class Minimap {
 public:
  // True while the mouse acts on it, so that it must not act on the canvas; then `centre` is the place to be
  // shown, in level px, if there is one. `hovered`: the mouse is on the canvas.
  bool update(const TileMap& map, const CanvasView& view, const Ui& ui, bool hovered,
              std::optional<Vec2>& centre);
  // `name`: of its widget.
  void draw(ImDrawList& list, const TileMap& map, const CanvasView& view, Ui& ui,
            std::string_view name) const;

 private:
  bool dragging_ = false;
};

}  // namespace talus
