// The ground tool: the user says which cells are ground, and the level's auto-tile set gives each its tile by
// which of its neighbours are ground too, as in the auto-tiling of other editors.
#pragma once

#include <span>

#include <talus/collision/function_ref.h>
#include "cell_painter.h"

namespace talus {

// The tile of a ground cell. Beyond the map all is ground, so that ground which goes on there has no edge.
//
// A side faces air where the cell beside it is no ground; of two opposite sides that do, a column has
// neither, and a row is a top. A step of the stairs, whose lower neighbour stands on the ground below, is a
// slope: of two tiles where the tread has room and the set has both halves, else of one. A part that the set
// does not have is played by the next best: a corner by the top or bottom, then by the side, all by the
// inside.
//
// set: must have a tile for the inside (asserted).
std::uint8_t ground_tile(const AutoTiles& set, FunctionRef<bool(Cell)> is_ground, Cell cell);

enum class GroundChange { add, remove };

// Makes the cells of a straight line ground, or takes the ground away there, and gives the ground around them
// the tiles that fit. The order in which cells are painted does not matter. Without a tile for the inside
// nothing happens, and removing leaves what is no ground alone. Cells outside `within` stay as they are.
Edit paint_ground(const Level& level, Cell from, Cell to, GroundChange change, Within within = {});
// The same with a rectangle.
Edit fill_ground(const Level& level, CellRect cells, GroundChange change, Within within = {});

// What the sheet has for ground. Slopes are told by their shapes, full tiles by their shapes and by which of
// their sides are drawn unlike their middle; the others are those that look most like the inside.
// among: tiles to choose from, in this order. A set without an inside when none of them is solid.
AutoTiles proposed_auto_tiles(const Level& level, std::span<const std::uint8_t> among);

Edit set_auto_tiles(const Level& level, const AutoTiles& tiles);

}  // namespace talus
