// Edits the animations of tiles.
#pragma once

#include <vector>

#include "level/edit.h"

namespace talus {

// Each edit is empty if the tile or the frame does not exist, or if nothing changes.

// Adds frames that show these tiles, as long as the last frame; the first one of a tile is 100 ms long.
Edit add_frames(const Level& level, TileNumber tile, const std::vector<TileNumber>& shown);
// Gives a frame another picture or duration. The duration is brought within 1..kMaxFrameDuration.
Edit change_frame(const Level& level, TileNumber tile, int index, AnimationFrame frame);
// Removes a frame; with the last one the animation goes.
Edit remove_frame(const Level& level, TileNumber tile, int index);
// Puts a frame at the index `to`.
Edit move_frame(const Level& level, TileNumber tile, int index, int to);
// Removes the animation.
Edit remove_animation(const Level& level, TileNumber tile);

}  // namespace talus
