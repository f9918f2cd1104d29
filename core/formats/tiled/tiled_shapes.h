// Outlines of tiles in Tiled as shapes of a level.
#pragma once

#include <optional>
#include <string>

#include "tiled_map.h"

namespace talus {

// The outline of a box, a polygon or an ellipse (see polygon_of_ellipse), in px from its tile's top left
// corner; empty for other objects. Boxes are clockwise, polygons as they were drawn. The rotation of the
// object is applied.
std::vector<Vec2> outline_of(const TiledObject& object);

// A box or polygon of a tile of that size as it appears in cells that turn it; other objects stay as they
// are.
TiledObject turned(const TiledObject& object, std::uint32_t turn, TileSize tile);

// An object as a polygon that is larger by these factors; one without an outline stays as it is.
TiledObject stretched(const TiledObject& object, Vec2 by);

// Returns the shape that an outline is: either the whole tile, or the ground between a line over whole tiles,
// from the left side of the tile on, and the bottom (a floor) or the top (a ceiling). The direction and the
// first point of the outline do not matter. Beside the ground, the line may lie on the bottom or the top.
// Corners of the line must be at equal distances, as those of a profile. Returns nothing for any other
// outline. one_way: whether only the line should stop bodies, which an outline cannot say.
// tile: the size of the tiles.
std::optional<TileShape> tile_shape_of(const std::vector<Vec2>& outline, bool one_way, TileSize tile);

// Returns the polygon that an outline is, welded and without points at the place of the one before. Returns
// nothing if no level can hold it (see problem_of). one_way: see tile_shape_of.
std::optional<TileShape> polygon_of(const std::vector<Vec2>& outline, bool one_way, TileSize tile);

// The most corners of a collision shape that are looked at; far more than 64 px can show.
inline constexpr std::size_t kMaxCorners = 1024;

// Whether an object of a tile says that it stays a polygon, where its outline is that of a slope, too.
// Without that word such an outline is a slope.
bool says_polygon(const TiledObject& object);
// The property of that word.
TiledProperty polygon_word();
// Returns what the outline of an object of a tile is: what tile_shape_of() or polygon_of() gives. outline: of
// the object, in px from the tile's corner. is_ceiling: whether a one-way line at the top of the tile stops
// bodies from below; else they stand on it.
std::optional<TileShape> shape_of_object(const TiledObject& object, const std::vector<Vec2>& outline,
                                         bool one_way, bool is_ceiling, TileSize tile);

// The shape that comes nearest to an outline.
struct NearestShape {
  TileShape shape;
  double more = 0, less = 0;  // px²: ground that only the shape has, and ground that only the outline has
};
// Returns a floor through the outline's upper line or a ceiling through its lower one, whichever covers it
// better. If most of either would lie outside of the outline, the outline hangs in the air: then it is a
// one-way floor along the upper line. Returns nothing if no area of it is within kMaxShapeTiles tiles to
// the right of the tile's left side, and as many up.
std::optional<NearestShape> nearest_tile_shape(const std::vector<Vec2>& outline, TileSize tile);
// Returns how the shape differs from the outline that it stands for, as the end of a sentence.
std::string difference_text(const NearestShape& nearest);

// Returns the shape with the heights in the tile's properties, if these give the same line: it may have more
// of them than its corners need. Else the shape as it is.
TileShape as_in_words(const TileShape& shape, const TiledTile& tile, TileSize size);

}  // namespace talus
