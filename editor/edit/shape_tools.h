// Tools for the shapes of the ground. Each makes an Edit and changes nothing itself.
#pragma once

#include "edit.h"
#include "level/slope_tiles.h"

namespace talus {

// The shape should be usable (see problem_of): others are kept, linted and not saved.
Edit set_tile_shape(const Level& level, int tile, TileShape shape);  // tile: 0..255 (asserted)
Edit set_flag_shape(const Level& level, int flag, TileShape shape);  // flag: 0..7 (asserted)
Edit set_curves(const Level& level, std::vector<LevelCurve> curves, std::string label);

// Puts the tiles along a slope on the map; they must have been made for this level.
Edit put_slope_tiles(const Level& level, const SlopeTiles& tiles);

}  // namespace talus
