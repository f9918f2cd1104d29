// PixelSelection: the selected pixels of a canvas. Once moved, turned or pasted they float: what lies below
// them comes back when they move on.
#pragma once

#include <optional>
#include <string>

#include "sprite_area.h"

namespace talus {

class PixelSelection {
 public:
  // px of the canvas; of floating pixels it may reach over the canvas's edge, but one px stays inside.
  const std::optional<CellRect>& rect() const { return rect_; }
  // Whether they float: the canvas is as they were put.
  bool floats(const Level& level, const SpriteArea& area) const;
  // What is selected, with what floats beyond the canvas's edge. rect() must hold.
  PixelBlock pixels(const Level& level, const SpriteArea& area) const;

  // Of the canvas; clamped to it. What floated stays where it is.
  void select(const SpriteArea& area, CellRect rect);
  void drop();
  // Drops pixels that floated and are no longer where they were put, as after an undo.
  void check(const Level& level, const SpriteArea& area);

  // Each makes the edit that shows the pixels as they are then; rect() must hold, but for pasting. `hole`:
  // the colour that is left where they are lifted from the canvas.
  Edit move(const Level& level, const SpriteArea& area, Cell by, std::uint8_t hole);
  Edit turn(const Level& level, const SpriteArea& area, PixelTurn how, std::uint8_t hole);
  Edit paste(const Level& level, const SpriteArea& area, PixelBlock block, Cell at);

 private:
  void lift(const Level& level, const SpriteArea& area, std::uint8_t hole);
  Edit put(const Level& level, const SpriteArea& area, std::string label) const;
  PixelBlock shown() const;  // the canvas with what floats on it
  void keep_inside(const SpriteArea& area);

  std::optional<CellRect> rect_;
  PixelBlock pixels_, below_;  // below_: the whole canvas without them; empty: they never floated
};

}  // namespace talus
