// The ground's outline and the level's curves, as lines in level pixels.
#pragma once

#include <vector>

#include <talus/level/level.h>
#include "overlay.h"

namespace talus {

// Adds the visible part of the merged outline (level px), with short normals on the sides that stop bodies.
void add_outline(const Terrain& ground, Rect visible, OverlayDrawing& drawing);
// Adds arrows through the one-way parts of the outline.
void add_one_way_arrows(const Terrain& ground, Rect visible, OverlayDrawing& drawing);

struct CurveLine {
  Vec2 from, to;  // px
};
// Returns the visible part of the level's curves, each from left to right. Invalid curves are left out.
std::vector<CurveLine> curve_lines(const Level& level, Rect visible);

}  // namespace talus
