// The ground's outline as closed polygons. The terrain keeps it as pieces by cell, cut where lines cross and
// not chained, so this merges the shapes of the tiles anew, column of cells by column.
#pragma once

#include <vector>

#include <talus/collision/terrain.h>
#include <talus/formats/format.h>

namespace talus {

// One closed ring, px; the last point is joined to the first. On the screen, ground is on the right hand of
// who walks along the points: a ring around ground goes clockwise, one around a hole the other way.
struct GroundPolygon {
  bool is_hole = false;
  std::vector<Vec2> points;  // three at least; none lies on a straight line between its neighbours
  friend bool operator==(const GroundPolygon&, const GroundPolygon&) = default;
};

// What is ground throughout: full tiles, and what is under the lines of floors and above those of ceilings.
// One-way lines and curves are thin, and not in it. Shapes that reach over the map's edge stay whole.
//
// Points are exact but where lines cross: those are rounded to 1/256 px. Parts that touch in a corner alone
// are polygons of their own, or one whose outline comes by that corner twice. By their leftmost points, then
// the topmost. The ground's progress is told; when it says so, there are none. An error: they would have more
// sides than kMaxGroundSides, as of millions of tiles that stand alone, which would take gigabytes.
FormatResult<std::vector<GroundPolygon>> ground_polygons(const TerrainSource& ground);
inline constexpr std::size_t kMaxGroundSides = std::size_t{1} << 23;  // cut at the sides of cells

// Whether b lies on the straight way from a to c, exactly.
bool is_straight(Vec2 a, Vec2 b, Vec2 c);

}  // namespace talus
