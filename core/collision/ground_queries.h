// What games and overlays ask of the ground. Every number is answered: a box that cannot be cast (a
// coordinate that is no number or infinite, a size that is negative or over kMaxCastSize, numbers beyond
// kMaxCastReach) is nowhere, meets nothing and overlaps nothing.
#pragma once

#include <optional>

#include <talus/collision/cast.h>

namespace talus {

// The floor that a box would stand on, straight below it, or the ceiling that it would touch straight above.
struct Surface {
  double y = 0;             // px, of the box's bottom side when it stands there; of its top side at a ceiling
  Vec2 normal;              // unit, out of the ground
  std::int32_t origin = 0;  // as Piece::origin
};

// reach: px, how far to look, may be infinite; negative or no number: not at all. None: there is nothing
// within it, or the box is inside of the ground.
std::optional<Surface> floor_below(const Terrain& ground, const Rect& box, double reach,
                                   Foot foot = Foot::box);
std::optional<Surface> ceiling_above(const Terrain& ground, const Rect& box, double reach);

// Where a straight line first meets the outline from outside; none: nowhere, or an end is beyond
// kMaxCastReach.
std::optional<Contact<double>> cast_segment(const Terrain& ground, Vec2 from, Vec2 to);

// Whether a box overlaps the ground by more than rounding: full tiles, and what is under the lines of slopes.
// Thin curves and one-way lines have no inside. With the centre as its foot a box may sink by its corners
// into slopes and the tiles that they lead to.
template <class Real>
bool overlaps_ground(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot = Foot::box);

// The shortest straight way out of the ground, along x or y and past one piece of the outline; none: the box
// is not in the ground, or none of the shortest 1024 ways frees it.
template <class Real>
std::optional<BasicVec2<Real>> way_out(const BasicTerrain<Real>& ground, const BasicRect<Real>& box,
                                       Foot foot = Foot::box);

}  // namespace talus
