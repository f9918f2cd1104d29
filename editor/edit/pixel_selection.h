// PixelSelection: the selected pixels of a canvas. Moved, turned or pasted pixels float: what is below them
// comes back when they move on.
#pragma once

#include <optional>
#include <string>

#include "sprite_area.h"

namespace talus {

class PixelSelection {
 public:
  // px of the canvas. Floating pixels may reach over the canvas's edge, but at least one px stays inside.
  const std::optional<CellRect>& rect() const { return rect_; }
  // Whether they float, and the canvas shows them as they were put.
  bool floats(const Level& level, const SpriteArea& area) const;
  // The selected pixels, also floating ones beyond the canvas's edge. rect() must hold.
  PixelBlock pixels(const Level& level, const SpriteArea& area) const;

  // px of the canvas; clamped to it. Pixels that floated stay where they are.
  void select(const SpriteArea& area, CellRect rect);
  void drop();
  // Drops floating pixels that are no longer where they were put, as after an undo.
  void check(const Level& level, const SpriteArea& area);

  // Each makes the edit that shows the pixels in their new place or form. rect() must hold, except for
  // pasting. `hole`: the colour that is left where they are lifted from the canvas.
  Edit move(const Level& level, const SpriteArea& area, Cell by, PixelColor hole);
  Edit turn(const Level& level, const SpriteArea& area, PixelTurn how, PixelColor hole);
  Edit paste(const Level& level, const SpriteArea& area, PixelBlock block, Cell at);

 private:
  void lift(const Level& level, const SpriteArea& area, PixelColor hole);
  Edit put(const Level& level, const SpriteArea& area, std::string label) const;
  PixelBlock shown() const;  // the canvas with the floating pixels on it
  void keep_inside(const SpriteArea& area);

  std::optional<CellRect> rect_;
  PixelBlock pixels_, below_;  // below_: the whole canvas without them; empty: they never floated
};

}  // namespace talus
