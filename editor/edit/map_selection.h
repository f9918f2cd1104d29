// Edits of the selected cells of the map. Each function makes an Edit and changes nothing itself.
#pragma once

#include "stamp.h"
#include "undo_stack.h"

namespace talus {

struct MovedCells {
  Edit edit;       // with the new selection; it may have no changes if the tiles look the same there
  int stroke = 0;  // the stroke to apply it with
};

// Moves the tiles of the selection, and the selection, by so many cells, but not over the map's edge. Tile 0
// stays in their old place, or with `leave_copy` the tiles themselves. If the last entry of the history moved
// or pasted just these, it is extended: what they covered in between comes back, and all of it is one entry.
// new_stroke: for a new entry, as in Session::next_stroke().
MovedCells move_selection(const Level& level, const UndoStack& history, CellRect selection, Cell by,
                          int new_stroke, bool leave_copy = false);

// Puts tiles with their top-left cell at `at`, and selects them. selected: the selection before. The edit is
// empty if none of the tiles is on the map.
Edit paste_cells(const Level& level, Cell at, const Stamp& tiles, std::optional<CellRect> selected);

}  // namespace talus
