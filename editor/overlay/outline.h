// The ground's outline and the level's curves, as lines in level pixels.
#pragma once

#include <vector>

#include <talus/level/level.h>
#include "overlay.h"

namespace talus {

// Adds the merged outline where it is visible (level px), with short normals on the sides from which it stops
// bodies.
void add_outline(const Terrain& ground, Rect visible, OverlayDrawing& drawing);
// Adds arrows through its one-way parts.
void add_one_way_arrows(const Terrain& ground, Rect visible, OverlayDrawing& drawing);

struct CurveLine {
  Vec2 from, to;  // px
};
// The visible part of the level's curves, left to right each. Those that cannot be used are left out.
std::vector<CurveLine> curve_lines(const Level& level, Rect visible);

}  // namespace talus
