// The levels that File > New and the welcome page start.
#pragma once

#include <talus/level/level.h>

namespace talus {

// What a new level begins with.
struct NewContent {
  bool in_true_colour = false;  // the sheet of tiles is painted in true colour, else in the palette
  // Has ground with slopes, a ball and a player who runs over it; else the level is empty. Of a map of less
  // than 30x17 cells the scene is cut.
  bool plays = false;
  friend bool operator==(const NewContent&, const NewContent&) = default;
};

// tile: px. width, height: cells; is_terrain_size must allow them (asserted).
Level new_level(TileSize tile, int width, int height, NewContent content);

}  // namespace talus
