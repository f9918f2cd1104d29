// What merging the shapes into one outline took away.
#pragma once

#include "overlay.h"

namespace talus {

// The level and upright sides of tiles and slopes that are no part of the outline, where visible (level px).
void add_removed_edges(const Terrain& ground, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
