// Cuts a polygon into the parts that an outline is made of.
#pragma once

#include <vector>

#include <talus/collision/shape.h>
#include "tile_outlines.h"

namespace talus {

// The columns of cells that points are in, from the first to the last, counted from the tile's own cell. A
// point on a border counts to the column on the side where the other points are.
struct ColumnSpan {
  int first, last;
};
ColumnSpan columns_of(const TileShape& polygon, TileSize tile);

// Appends the parts of a polygon, column by column, and in each from the left. Each is between two sides that
// have nothing but ground between them. number: see TileColumn::polygon.
void cut_polygon(const TileShape& polygon, int number, TileSize tile, std::vector<TileColumn>& out);

}  // namespace talus
