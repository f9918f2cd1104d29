// The ground tool: the user says which cells are ground. The level's auto-tile set gives each cell its tile,
// depending on which of its neighbours are ground, as in the auto-tiling of other editors.
#pragma once

#include <span>

#include <talus/collision/function_ref.h>
#include "cell_painter.h"

namespace talus {

// Returns the tile of a ground cell. Everything beyond the map counts as ground, so ground has no edge there.
//
// A side faces air if the cell beside it is not ground. If both opposite sides face air, a column has neither
// side, and a row is a top. A step of the stairs, whose lower neighbour stands on the ground below, is a
// slope: of two tiles if the tread has room and the set has both halves, else of one. A part that the set
// does not have is replaced by the next best: a corner by the top or bottom, then by the side; all parts by
// the inside.
//
// set: must have a tile for the inside (asserted).
TileNumber ground_tile(const AutoTiles& set, FunctionRef<bool(Cell)> is_ground, Cell cell);

enum class GroundChange { add, remove };

// Makes the cells of a straight line ground, or removes the ground there, and gives the ground around them
// fitting tiles. The order in which cells are painted does not matter. Without a tile for the inside nothing
// happens. Removing leaves cells alone that are not ground. Cells outside `within` stay as they are.
Edit paint_ground(const Level& level, Cell from, Cell to, GroundChange change, Within within = {});
// The same with a rectangle.
Edit fill_ground(const Level& level, CellRect cells, GroundChange change, Within within = {});

// Gives full tiles of the set, in the cells that an edit changes and beside them, the part that fits what is
// around them after the edit. Slopes stay as they are. Without a tile for the inside nothing happens.
void fit_ground(const Level& level, Edit& edit, Within within = {});

// Proposes a set for ground from the tiles of the sheet. Slopes are recognised by their shapes, full tiles by
// their shapes and by the sides that are drawn unlike their middle; the others are those that look most like
// the inside. among: tiles to choose from, in this order. If none of them is solid and the sheet is in true
// colour, those without a shape that are wholly opaque count as solid. Returns a set without an inside if
// there are none.
AutoTiles proposed_auto_tiles(const Level& level, std::span<const TileNumber> among);

// Sets the proposed tiles, and makes those of them solid that have no shape.
Edit propose_auto_tiles(const Level& level, std::span<const TileNumber> among);

Edit set_auto_tiles(const Level& level, const AutoTiles& tiles);

}  // namespace talus
