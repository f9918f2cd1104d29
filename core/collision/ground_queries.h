// Queries of the ground, for games and overlays. Every query has an answer: a box that cannot be cast (a
// coordinate that is not finite, a size that is negative or over kMaxCastSize, numbers beyond kMaxCastReach)
// meets nothing and overlaps nothing.
#pragma once

#include <optional>

#include <talus/collision/cast.h>

namespace talus {

// A limit for the work of one query about a body, for callers that ask about many: about 1 ms.
inline constexpr std::int64_t kMaxQueryWork = 1 << 15;

// The floor straight below a box, or the ceiling straight above it.
struct Surface {
  // px; for a floor the y of the box's bottom when it stands there, for a ceiling the y of its top
  double y = 0;
  Vec2 normal;              // unit, out of the ground
  std::int32_t origin = 0;  // as Piece::origin
};

// reach: px, how far to search; may be infinite. Returns nothing if there is no floor (or ceiling) within
// reach, if the box is inside the ground, or if reach is negative or NaN. budget: the work of the search is
// taken from it, and once it is used up, the function returns nothing; null: no limit.
std::optional<Surface> floor_below(const Terrain& ground, const Rect& box, double reach,
                                   Foot foot = Foot::box, CastBudget* budget = nullptr);
std::optional<Surface> ceiling_above(const Terrain& ground, const Rect& box, double reach);

// The place where a straight line first meets the outline from outside. Returns nothing if it meets none, or
// if an end is beyond kMaxCastReach.
std::optional<Contact<double>> cast_segment(const Terrain& ground, Vec2 from, Vec2 to);

// Whether a box overlaps the ground by more than rounding. Full tiles count, and what is under the lines of
// slopes. Thin curves and one-way lines have no inside. If the foot is the centre, the corners of the box may
// sink into slopes and into the tiles that they lead to.
template <class Real>
bool overlaps_ground(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot = Foot::box);

// The shortest straight way out of the ground: along x or y, and past one piece of the outline. A box that
// stands on its middle is not led through ground there, nor up if its floor is nearer. Returns nothing if the
// box is not in the ground, or if none of the shortest 1024 ways frees it. budget: the work is taken from it,
// and once it is used up, the function returns nothing; null: no limit.
template <class Real>
std::optional<BasicVec2<Real>> way_out(const BasicTerrain<Real>& ground, const BasicRect<Real>& box,
                                       Foot foot = Foot::box, CastBudget* budget = nullptr);

// px/frame: how fast the surface that a box touches goes along it, clockwise around the ground: on a floor to
// the right. On level ground and at upright walls it is the mean of all the ground along the side of the box,
// by the px of the side that lie on each; a side without length counts what is at its place, and equally what
// meets there. Elsewhere that of the contact counts, and where nothing is at the side.
template <class Real>
double conveyor_at(const BasicTerrain<Real>& ground, const Contact<Real>& contact,
                   const BasicRect<Real>& box);

inline constexpr int kMaxCellsUp = 16;  // how far up free_above() looks

// Returns the y (px, of the box's top) of the nearest place straight above that is free of the ground,
// standing on it; nothing if there is none within kMaxCellsUp cells.
template <class Real>
std::optional<Real> free_above(const BasicTerrain<Real>& ground, const BasicRect<Real>& box,
                               Foot foot = Foot::box);

}  // namespace talus
