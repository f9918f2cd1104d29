// Tools for shapes that are polygons or groups. Each returns a new shape, which may be invalid (see
// problem_of()), and changes nothing else. Places are px from the tile's top left.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// Where points of polygons are put.
enum class PointSnap : std::uint8_t {
  corners,  // at corners of cells
  halves,   // at corners of cells, and half way between them
  pixels,   // at whole px
  free      // anywhere, rounded to 1/256 px
};
inline constexpr int kPointSnapCount = 4;

// The nearest place for a point; of two, the one further from the tile's top left.
Vec2 snapped(Vec2 place, PointSnap snap, TileSize tile);
// px, the distance of such places along each axis; free ones are 1/16 px apart, for the keyboard.
Vec2 snap_step(PointSnap snap, TileSize tile);
// The nearest place that is within kMaxShapeTiles tiles of the tile.
Vec2 kept_near(Vec2 place, TileSize tile);

// The same ground as polygons: one, or a group of several where the line of a slope or profile goes down to
// its base in between. Polygons, groups of polygons and nothing stay as they are. The base of a one-way line
// that goes down to it, and of ground without any height, is moved outwards by 1 px. A line of more points
// than a polygon may have loses every second one.
TileShape as_polygon(const TileShape& shape, TileSize tile);
// A profile along the upper side of a polygon or a group, or along the lower side of a polygon that is a
// ceiling, as wide as it reaches to the right. It has a height of 0 where there is no ground, or if the shape
// is invalid.
TileShape profile_along(const TileShape& shape, TileSize tile);

// The index of the nearest point within `reach` px of a place; nothing if there is none.
std::optional<std::size_t> point_near(const std::vector<Vec2>& points, Vec2 place, double reach);
// The index of the nearest side within `reach` px of a place; side i is that from point i to the next one.
std::optional<std::size_t> side_near(const std::vector<Vec2>& points, Vec2 place, double reach);

// A point of a polygon at another place, as near as points may be. point: its index (asserted).
TileShape with_point_at(TileShape polygon, std::size_t point, Vec2 place, TileSize tile);
// A new point on a side, beside `place`: snapped, or else at whole px, or else on the side, whichever leaves
// a usable polygon usable. side: its index (asserted); the new point has the index side + 1.
TileShape with_point_on(TileShape polygon, std::size_t side, Vec2 place, PointSnap snap, TileSize tile);
// Without a point, which is given by its index (asserted).
TileShape without_point(TileShape polygon, std::size_t point);
// A polygon moved as a whole by as much of `by` as its points may go.
TileShape moved_by(TileShape polygon, Vec2 by, TileSize tile);

// The number of parts of a group; 0 for nothing; 1 for all others, which are their own only part.
std::size_t part_count(const TileShape& shape);
// A part by its index, below part_count() (asserted).
const TileShape& part_at(const TileShape& shape, std::size_t part);
// The shape with another part at an index below part_count() (asserted). A part that is nothing is removed,
// and a group of one part becomes that part. The parts of a group take its place.
TileShape with_part_at(const TileShape& shape, std::size_t part, const TileShape& replacement);
// The shape with a further part, which is the last one then.
TileShape with_new_part(const TileShape& shape, const TileShape& part);
// The index of the last part whose ground or outline is within `reach` px of a place; nothing if there is
// none.
std::optional<std::size_t> part_near(const TileShape& shape, TileSize tile, Vec2 place, double reach);

}  // namespace talus
