// A shape as the solvers article and bump, and bump.lua, have it: boxes, each full or with one straight line
// across it.
#pragma once

#include <optional>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// A line from the left side of a box to its right side. Ground lies between it and the box's bottom, or, of a
// ceiling, its top.
struct BumpLine {
  double h0 = 0, h1 = 0;  // px at the left and the right side, from the bottom; of a ceiling from the top
  bool is_ceiling = false;
  bool one_way = false;  // the line alone stops bodies, and only from its open side
  friend bool operator==(const BumpLine&, const BumpLine&) = default;
};

struct BumpBox {
  Rect box;                      // px
  std::optional<BumpLine> line;  // none: it is full
  friend bool operator==(const BumpBox&, const BumpBox&) = default;
};

// The boxes of a shape, a usable one (see problem_of), from left to right, relative to its cell. With the
// cell's corner added to x and y they are those of add_ground() in assets/runtime/bump_slopes.lua, in its
// order and to the last bit. None of a shape without height.
std::vector<BumpBox> bump_boxes(const TileShape& shape);

}  // namespace talus
