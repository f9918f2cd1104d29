// How a box stands on a piece of the ground's outline.
#pragma once

#include <cmath>
#include <span>

#include <talus/collision/piece.h>
#include <talus/collision/shape.h>

namespace talus {

// How far right of a box's left side its part is that touches a sloped floor or ceiling.
template <class Real>
Real foot_offset(const Piece<Real>& piece, Real width, Foot foot) {
  const bool up = piece.facing == Facing::up;
  if (up && foot == Foot::centre) return width / 2;
  return piece.rises_to_the_right() == up ? width : 0;
}

// Unit, out of a curve that faces up or down, where its unit tangent from left to right is `along`.
template <class Real>
BasicVec2<Real> normal_on(BasicVec2<Real> along, Facing facing) {
  return facing == Facing::up ? BasicVec2<Real>{along.y, -along.x} : BasicVec2<Real>{-along.y, along.x};
}

// Whether a rounding of x moves the place more than a rounding of y. Not for curves.
template <class Real>
bool is_steep(const Piece<Real>& piece) {
  return std::abs(piece.slope) > 1;
}

// The top of a box at x that rests on the piece; box.y does not matter.
template <class Real>
Real rest_on(const Piece<Real>& piece, std::span<const CurveStretch<Real>> stretches,
             const BasicRect<Real>& box, Foot foot);

}  // namespace talus
