// What is done with the selected cells of the map. Each makes an Edit and changes nothing itself.
#pragma once

#include "stamp.h"
#include "undo_stack.h"

namespace talus {

struct MovedCells {
  Edit edit;       // with the new selection; its changes may be empty where the tiles look the same there
  int stroke = 0;  // to apply it with
};

// Moves the tiles of the selection, and the selection, by so many cells; no further than to the map's edge.
// Tile 0 stays where they were, or with `leave_copy` they do. While the last entry of the history moved or
// pasted just these, it is moved on: what they covered in between comes back, and all of it is one entry.
// new_stroke: for an entry that begins here, as Session::next_stroke().
MovedCells move_selection(const Level& level, const UndoStack& history, CellRect selection, Cell by,
                          int new_stroke, bool leave_copy = false);

// Puts tiles with their top-left cell at `at`, and selects them. selected: what was before. Empty where
// nothing of them is on the map.
Edit paste_cells(const Level& level, Cell at, const Stamp& tiles, std::optional<CellRect> selected);

}  // namespace talus
