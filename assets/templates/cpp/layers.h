// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Draws the layers of a level from the back to the front: of tiles, of objects with pictures, and pictures;
// then its curves.
#pragma once

#include <talus/collision/terrain.h>
#include <talus/level/level.h>

#include "painter.h"
#include "sheet.h"

namespace game {

class Layers {
 public:
  // The level must stay alive.
  explicit Layers(const talus::Level& level);
  talus::Rgb background() const;  // what is not opaque lies over black
  // time: ms since the start, which animated tiles go by.
  void draw(Painter& painter, double time) const;

 private:
  struct View;
  void draw_tiles(const View& view, int layer, bool skips_empty, double time) const;
  void draw_others(const View& view, const talus::ObjectLayer& layer) const;
  void draw_curves(Painter& painter) const;

  const talus::Level& level_;
  Sheet sheet_;            // of the tiles
  bool is_0_blank_;        // whether nothing is seen of tile 0
  talus::Terrain ground_;  // which knows where the curves run
};

}  // namespace game
