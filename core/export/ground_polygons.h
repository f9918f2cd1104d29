// The ground's outline as closed polygons. The terrain keeps the outline as pieces by cell, cut where lines
// cross and not linked. So the shapes of the tiles are merged anew here, column of cells by column.
#pragma once

#include <vector>

#include <talus/collision/terrain.h>
#include <talus/formats/format.h>

namespace talus {

// One closed ring, px; the last point is joined to the first. Seen along the points, ground is on the right:
// a ring around ground goes clockwise on the screen, one around a hole counter-clockwise.
struct GroundPolygon {
  bool is_hole = false;
  std::vector<Vec2> points;  // at least three; none lies on a straight line between its neighbours
  friend bool operator==(const GroundPolygon&, const GroundPolygon&) = default;
};

// All that is solid: full tiles, what is under the lines of floors, and what is above the lines of ceilings.
// One-way lines and curves are thin and not part of it. Shapes that reach over the map's edge stay whole.
//
// Points are exact, except where lines cross: those are rounded to 1/256 px. Parts that touch only in a
// corner are separate polygons, or one whose outline passes that corner twice. Sorted by their leftmost
// points, then the topmost. `progress` receives the progress; when it stops the work, the list is empty. More
// than `most_sides` sides are an error: millions of separate tiles would take gigabytes. Sides are cut at the
// sides of cells.
inline constexpr std::size_t kMaxGroundSides = std::size_t{1} << 23;
FormatResult<std::vector<GroundPolygon>> ground_polygons(const TerrainSource& ground,
                                                         std::size_t most_sides = kMaxGroundSides);

// Whether b lies exactly on the straight way from a to c.
bool is_straight(Vec2 a, Vec2 b, Vec2 c);

}  // namespace talus
