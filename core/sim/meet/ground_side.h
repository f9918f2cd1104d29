// GroundSide: a line of the ground's outline, or a stretch of a curve, as a circle meets it.
#pragma once

#include <vector>

#include <talus/collision/cast.h>
#include "form.h"

namespace talus {

struct GroundSide {
  Vec2 from, to;                         // px, its ends
  Vec2 along;                            // unit, of a line, from the first end to the second
  Vec2 normal;                           // unit, of a line, out of the ground
  Facing facing = Facing::up;            // the side that stops bodies
  std::int32_t origin = 0;               // as Piece::origin; of tiles side by side, that of the first one
  const Piece<double>* piece = nullptr;  // null: the side of full tiles
  const CurveStretch<double>* stretch = nullptr;  // of a curve; null: a line
  bool is_thin = false;    // there is no ground behind it: what is inside of it goes through
  bool is_hollow() const;  // a curve that bends towards what it stops
};

// Whether the first end of a side is nearer to a point than the second one, or as near.
bool is_first_nearer(const GroundSide& side, Vec2 point);
inline Vec2 nearer_end(const GroundSide& side, Vec2 point) {
  return is_first_nearer(side, point) ? side.from : side.to;
}

// How near a circle is to a side, or the corner of a box, a circle without a radius, to a curve that it
// touches. It is in front of the side, or behind it.
struct SideNearness {
  Nearness near;
  bool in_front = true;  // of a point at the end: level with the end counts
};
SideNearness nearness(const GroundSide& side, Vec2 middle, double radius);

// The side that a piece of the ground's outline is.
GroundSide side_of(const Piece<double>& piece, std::span<const CurveStretch<double>> stretches);

// Finds the sides in an area, px. Tiles side by side are one. Each side found costs 1, each row of tiles 1.
void find_sides(const Terrain& ground, const Rect& area, CastBudget& budget, std::vector<GroundSide>& found);

}  // namespace talus
