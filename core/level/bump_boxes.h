// A shape for the solvers article and bump, and for bump.lua: boxes that are full, or have one straight line
// across them.
#pragma once

#include <optional>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// A line from the left side of a box to its right side. Ground lies between the line and the box's bottom;
// for a ceiling, its top.
struct BumpLine {
  double h0 = 0, h1 = 0;  // px at the left and the right side, from the bottom; for a ceiling from the top
  bool is_ceiling = false;
  bool one_way = false;  // only the line stops bodies, and only those from its open side
  friend bool operator==(const BumpLine&, const BumpLine&) = default;
};

struct BumpBox {
  Rect box;                      // px
  std::optional<BumpLine> line;  // nothing: the box is full
  friend bool operator==(const BumpBox&, const BumpBox&) = default;
};

// Returns the boxes of a usable shape of tiles of a size (see problem_of) from left to right, relative to its
// cell. With the cell's corner added they are the same as those of add_ground() in
// assets/runtime/bump_slopes.lua, in the same order and to the last bit. Empty for a shape without height.
std::vector<BumpBox> bump_boxes(const TileShape& shape, TileSize tile);

// Whether the boxes are all of a usable shape. A part of a polygon whose upper and lower line both slope, and
// which no level line separates, has no box.
bool bump_takes_all_of(const TileShape& shape);
// The same for the article's solver, which of these boxes knows the full ones and the floors of a polygon or
// a group.
bool article_takes_all_of(const TileShape& shape, TileSize tile);

}  // namespace talus
