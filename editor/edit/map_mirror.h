// Mirrors the selected cells of the map, with the slopes in them.
#pragma once

#include <string>

#include "level/edit.h"

namespace talus {

enum class MirrorAxis { horizontal, vertical };  // swaps left and right, or top and bottom

struct MirroredCells {
  Edit edit;
  // Cells whose ground has no mirror image on the sheet, or lies only partly in the selection.
  int without_partner = 0;
  int unmirrored_art = 0;  // tiles with the right ground that are not drawn as the mirror image
};

// Tiles in true colour, such as those of maps of Tiled, are turned in their cells. The others, as in TIC-80,
// get another tile of the sheet: one that is the mirror image to the simulation, by its shape and role. If
// there are several, the one that looks most like the mirrored pixels. A tile that is its own mirror image to
// the simulation stays, unless a tile with the same flags has exactly the mirrored pixels. A slope over
// several cells is mirrored as a whole. What has no mirror image on the sheet is turned in its cell, and so
// are tiles that are turned already. In a cart's level, which has no turned tiles, such ground goes to its
// new place unchanged.
MirroredCells mirror_cells(const Level& level, CellRect cells, MirrorAxis axis);

// One sentence for the user on what could not be mirrored; empty if everything was.
std::string text_of_missing(const MirroredCells& mirrored);

}  // namespace talus
