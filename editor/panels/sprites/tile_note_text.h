// What a tile says of itself, in a line.
#pragma once

#include <string>

#include <talus/level/tile_note.h>

namespace talus {

// "class lava, probability 0.5, cost: 3", as it is in the file; empty for a tile without a note.
std::string text_of_note(const TileNote& note);

}  // namespace talus
