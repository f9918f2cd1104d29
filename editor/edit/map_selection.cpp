// Moves and pastes tiles.
#include "map_selection.h"

#include <algorithm>

#include "cell_painter.h"
#include "map_stroke.h"

namespace talus {
namespace {

using Tiles = SelectionChange::Tiles;

// The last entry of the history if it moved or pasted the tiles of this selection and can be extended; else
// null.
const Edit* edit_to_go_on(const UndoStack& history, CellRect selection) {
  if (history.open_stroke() == 0) return nullptr;
  const Edit& last = history.edits()[history.position() - 1];
  const bool fits =
      last.selection && last.selection->tiles != Tiles::stays && last.selection->after == selection;
  return fits ? &last : nullptr;
}

// The map before an edit.
TileMap map_before(TileMap map, const Edit& edit) {
  for (const Change& change : edit.changes) {
    if (const auto* whole = std::get_if<MapChange>(&change)) return whole->before;
    if (const auto* cell = std::get_if<CellChange>(&change)) map.set(cell->cell, cell->before);
  }
  return map;
}

template <class Visit>
void for_each_cell(const CellRect& cells, const Visit& visit) {
  for (int y = cells.y; y < cells.y + cells.h; ++y) {
    for (int x = cells.x; x < cells.x + cells.w; ++x) visit(Cell{x, y});
  }
}

}  // namespace

MovedCells move_selection(const Level& level, const UndoStack& history, CellRect selection, Cell by,
                          int new_stroke, bool leave_copy) {
  const TileMap& map = level.map;
  CellRect to = selection;
  to.x = std::clamp(selection.x + by.x, 0, map.width() - selection.w);
  to.y = std::clamp(selection.y + by.y, 0, map.height() - selection.h);

  const Edit* last = leave_copy ? nullptr : edit_to_go_on(history, selection);
  SelectionChange change{selection, to, leave_copy ? Tiles::put : Tiles::moved};
  std::optional<CellRect> hole;  // the cells that are left with tile 0
  if (last == nullptr && !leave_copy) hole = selection;
  if (last != nullptr) {
    change.tiles = last->selection->tiles;
    if (change.tiles == Tiles::moved) hole = last->selection->before;
  }
  const Stamp tiles = stamp_of_map(level, selection);

  CellPainter painter(map);
  for_each_cell(to, [&](Cell c) { painter.paint(c, tiles.at(c.x - to.x, c.y - to.y)); });
  if (hole) {
    for_each_cell(*hole, [&](Cell c) {
      if (!to.contains(c)) painter.paint(c, 0);
    });
  }
  if (last != nullptr) {
    const TileMap below = map_before(map, *last);
    for_each_cell(selection, [&](Cell c) {
      if (!to.contains(c) && !(hole && hole->contains(c))) painter.paint(c, below.at(c));
    });
  }
  MovedCells moved{painter.finish(leave_copy ? "Copy tiles" : "Move tiles"), new_stroke};
  moved.edit.selection = change;
  if (last != nullptr) moved.stroke = history.open_stroke();
  return moved;
}

Edit paste_cells(const Level& level, Cell at, const Stamp& tiles, std::optional<CellRect> selected) {
  Edit edit = paint_stamp(level, at, tiles);
  edit.label = "Paste tiles";
  const auto on_map = shared({at.x, at.y, tiles.w, tiles.h}, {0, 0, level.map.width(), level.map.height()});
  if (on_map) edit.selection = SelectionChange{selected, on_map, Tiles::put};
  return edit;
}

}  // namespace talus
