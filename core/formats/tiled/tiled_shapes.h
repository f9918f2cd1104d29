// Outlines of tiles in Tiled as shapes of a level.
#pragma once

#include <optional>

#include "tiled_map.h"

namespace talus {

// The outline of a box or polygon, in px from its tile's top left corner; no points for other objects. Boxes
// are clockwise, polygons as they were drawn. Turned by the object's rotation.
std::vector<Vec2> outline_of(const TiledObject& object);

// The shape that an outline is: the whole tile; or ground between one line over the tile's columns, from the
// left side of the tile over whole tiles, and the bottom (a floor) or the top (a ceiling). Whichever way
// round and from whichever point on it was drawn; beside it the line may lie on the bottom or the top, where
// there is nothing. Corners of the line are at equal distances, as those of a profile. Nothing for any other
// outline. one_way: whether the line alone is to stop bodies; it is not the outline's to say.
std::optional<TileShape> tile_shape_of(const std::vector<Vec2>& outline, bool one_way);

// What comes nearest to an outline that is no shape.
struct NearestShape {
  TileShape shape;
  double more = 0, less = 0;  // px², ground that the outline has not, and that the shape has not
};
// A floor through the outline's upper line or a ceiling through its lower one, whichever covers it better.
// Where most of both would be what the outline is not, it hangs in the air: a one-way floor along its upper
// line. Nothing where there is no area of it from the tile's left side on, up to 64 px to the right and up.
std::optional<NearestShape> nearest_tile_shape(const std::vector<Vec2>& outline);

}  // namespace talus
