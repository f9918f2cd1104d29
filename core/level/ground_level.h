// A level with several layers of tiles, for what looks at its ground alone.
#pragma once

#include "edit.h"
#include "ground_names.h"

namespace talus {

// Whether the map of a level is its ground: it has one layer, which is ground, and no turned tiles.
bool has_plain_ground(const Level& level);

// The level with the ground of all layers as its map. A stack of tiles (see ground_cells.h) has a number from
// tile_count() on, its shape, no flags and no picture; a turned tile has that of the tile. Levels with too
// many different stacks have no tiles on their map. names: gets what its tiles are called, unless null.
Level ground_level(const Level& level, GroundNames* names = nullptr);
// Gives a cell of that level what it has in `level` now. Returns whether it could: it cannot if the stack of
// tiles there is a new one.
bool update_cell(const Level& level, Cell cell, Level& of_ground);

// Whether an edit of ground_level() does the same to `level`: the chosen layer has the tiles that it changes.
bool fits_layers(const Level& level, const Edit& edit);

}  // namespace talus
