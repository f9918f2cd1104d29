// Named brushes, and painting with tiles at random.
#pragma once

#include "cell_painter.h"
#include "stamp.h"

namespace talus {

// What a cell gets of a stamp at random. It is always the same with this seed, so painting a cell
// twice, or undo and redo, changes nothing. notes: of the level; a tile comes as often as its probability
// says, and each as often as any other if all are 0.
MapCell random_tile(const Stamp& stamp, Cell cell, std::uint32_t seed, const TileNotes& notes = {});

// Paints the cells of the straight line between two, both included, each with a random tile. `within`:
// nothing beyond it is painted.
Edit paint_random_stroke(const Level& level, Cell from, Cell to, const Stamp& stamp, std::uint32_t seed,
                         Within within = {});
Edit fill_rect_at_random(const Level& level, CellRect cells, const Stamp& stamp, std::uint32_t seed,
                         Within within = {});

Stamp stamp_of_brush(const Brush& brush);
// A stamp as a brush; cut off at kMaxBrushSide.
Brush brush_of_stamp(const Stamp& stamp, std::string name, bool random);

// Each edits the level's list of brushes. The edit is empty if there is no brush `index`, or the list is
// full.
Edit add_brush(const Level& level, Brush brush);
Edit rename_brush(const Level& level, int index, std::string name);  // cut off at kMaxBrushName
Edit remove_brush(const Level& level, int index);
// Returns "Brush 3": the first such name that no brush has.
std::string free_brush_name(const Level& level);

}  // namespace talus
