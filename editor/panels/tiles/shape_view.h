// What the shape editor shows, besides the level.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "edit/polygon_tools.h"

namespace talus {

struct ShapeView {
  PointSnap snap = PointSnap::pixels;        // of points of polygons
  std::size_t part = 0;                      // of a group, the part that is edited
  std::optional<std::size_t> point;          // of a polygon, the chosen one
  std::optional<std::vector<Vec2>> drawing;  // px, the points of an unfinished polygon
  std::optional<TileShape> draft;            // an invalid shape, which is not in the level
  int tile = -1;                             // the tile that `drawing` and `draft` are for
  TileShape before;                          // its own shape, on which `draft` is based
  int last_frame = 0;                        // number of the last frame in which the editor was drawn

  void forget_unfinished() {
    drawing.reset();
    draft.reset();
  }
  void forget_level() {  // another level is open
    forget_unfinished();
    part = 0;
    point.reset();
  }
};

}  // namespace talus
