// The cells that a player can get to, as boxes and lines in level pixels.
#pragma once

#include "overlay.h"
#include "sim/reach.h"

namespace talus {

// Adds the reached cells, tinted, and a line under those in which the player stood. stale: the level has
// changed since the search; then the cells have only an outline. map: the searched one.
void add_reach(const ReachSearch& reach, bool stale, const TileMap& map, Rect visible,
               OverlayDrawing& drawing);

}  // namespace talus
