// The levels that File > New and the welcome page start.
#pragma once

#include <talus/level/level.h>

namespace talus {

// What a new level begins with.
struct NewContent {
  // The sheet of tiles is painted in true colour, else in the palette. Tiles of another size than 8x8 px are
  // always in true colour, as images of the palette have that size alone.
  bool in_true_colour = false;
  // Has ground with slopes, a ball and a player who runs over it; else the level is empty. Of a map of less
  // than 30x17 cells the scene is cut.
  bool plays = false;
  friend bool operator==(const NewContent&, const NewContent&) = default;
};

// tile: px. width, height: cells; is_terrain_size must allow them (asserted).
Level new_level(TileSize tile, int width, int height, NewContent content);

}  // namespace talus
