// Random polygons and groups, and what of the map is inside of them.
#pragma once

#include "random_ground.h"

namespace talus {

// A polygon near its tile, at most a tile away from it. Most are on a coarse grid, so that sides of several
// lie on one another.
TileShape random_polygon(Dice& dice, TileSize tile, bool one_way);
// Parts of all kinds, each one tile wide.
TileShape random_group(Dice& dice, TileSize tile, bool one_way);

// The rows that a shape reaches over, counted from its own one; and the columns.
struct ShapeReach {
  int left = 0, top = 0, right = 0, bottom = 0;
};
ShapeReach reach_of(const TileShape& shape, TileSize tile);

// The shape mirrored about the vertical through the middle of its tile, if it is one tile wide.
TileShape mirrored_in_tile(const TileShape& shape, TileSize tile);

// For the reference: a polygon as triangles, or its lines if it is one-way.
void add_polygon(const TileShape& polygon, TileSize tile, int column, int row,
                 std::vector<reference::Part>& parts);

// Whether a place, px, is in the ground of a shape whose tile has its top left at the origin. Not exact on
// its border. One-way shapes have no ground.
bool is_inside(const TileShape& shape, TileSize tile, double x, double y);

}  // namespace talus
