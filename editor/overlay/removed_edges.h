// The sides of shapes that disappeared when they were merged into one outline.
#pragma once

#include "overlay.h"

namespace talus {

// Adds the visible horizontal and vertical sides of tiles and slopes that are not on the outline (level px).
void add_removed_edges(const Terrain& ground, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
