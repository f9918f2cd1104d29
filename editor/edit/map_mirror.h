// Mirroring the selected cells of the map, with the slopes in them.
#pragma once

#include <string>

#include "edit.h"

namespace talus {

enum class MirrorAxis { horizontal, vertical };  // left and right, or up and down, change places

struct MirroredCells {
  Edit edit;
  int without_partner = 0;  // whose ground has no mirror image on the sheet, or only partly lies here
  int unmirrored_art = 0;   // tiles that play their part, but are not drawn as the mirror image
};

// TIC-80's maps cannot turn a tile, so that each cell gets another tile of the sheet: one that is the mirror
// image to the simulation, by its shape and role. Where several are, that which looks most like the mirrored
// pixels; what is its own mirror image to the simulation stays, unless a tile with the same flags has exactly
// the mirrored pixels. A slope over several cells is mirrored as a whole. Ground without a mirror image on
// the sheet goes to its new place as it is.
MirroredCells mirror_cells(const Level& level, CellRect cells, MirrorAxis axis);

// What could not be mirrored, as one sentence for the user; empty: nothing.
std::string text_of_missing(const MirroredCells& mirrored);

}  // namespace talus
