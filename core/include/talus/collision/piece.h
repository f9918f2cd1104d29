// One piece of the ground's outline: a straight line, a monotone stretch of a curve, or a wall.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <talus/collision/geometry.h>

namespace talus {

// The direction of a piece's normal; the piece stops only bodies that come from there. A wall faces left or
// right.
enum class Facing : std::uint8_t { up, down, left, right };

// sin(2 pi turns), for |turns| <= 1/4. Not the C library's, which differs between machines. Odd to the last
// bit.
template <class Real>
Real sine_of_turns(Real turns);
// The cosine of the same.
template <class Real>
Real cosine_of_turns(Real turns);

// A stretch of a curve y = f(x) on which f rises or falls throughout and bends to one side only.
template <class Real>
struct CurveStretch {
  // What the coefficients mean.
  enum class Kind : std::uint8_t {
    arc,         // c: centre x, centre y, radius; sign: -1 the upper half, +1 the lower
    polynomial,  // c: middle x, then the coefficients of (x - middle)^0 to ^3
    sine         // c: x of the zero crossing, middle y, amplitude, wavelength
  };
  Kind kind = Kind::polynomial;  // how y is computed
  Real sign = 1;                 // for an arc -1 or +1; else 1
  Real c[5] = {};                // coefficients, as Kind says, px
  bool bends_down = false;       // f'' > 0: y grows to both sides, as a hill's does

  // px: the height at x, px, which must be within the stretch.
  Real y_at(Real x) const {
    const Real u = x - c[0];
    switch (kind) {
      case Kind::arc:
        return c[1] + sign * std::sqrt(std::max<Real>(0, (c[2] - u) * (c[2] + u)));
      case Kind::polynomial:
        return (c[1] + u * u * c[3]) + u * (c[2] + u * u * c[4]);
      case Kind::sine:
        return c[1] + c[2] * sine_of_turns(u / c[3]);
    }
    return 0;
  }

  // Unit tangent, from left to right, at x, px, within the stretch; also at an arc's vertical end.
  BasicVec2<Real> tangent_at(Real x) const {
    const Real u = x - c[0];
    if (kind == Kind::arc)
      return {std::sqrt(std::max<Real>(0, (c[2] - u) * (c[2] + u))) / c[2], -sign * u / c[2]};
    Real slope = c[2] + u * (2 * c[3]) + u * u * (3 * c[4]);
    if (kind == Kind::sine) slope = c[2] * (kTwoPi / c[3]) * cosine_of_turns(u / c[3]);
    const Real length = std::sqrt(1 + slope * slope);
    return {1 / length, slope / length};
  }

  // 1/px, at least 0: one over the radius of the circle that fits the curve best at x, px, within the
  // stretch.
  Real curvature_at(Real x) const {
    if (kind == Kind::arc) return 1 / c[2];
    const Real u = x - c[0];
    Real second = 2 * c[3] + 6 * c[4] * u;
    if (kind == Kind::sine) second = c[2] * (kTwoPi / c[3]) * (kTwoPi / c[3]) * sine_of_turns(u / c[3]);
    const Real flat = tangent_at(x).x;
    return std::abs(second) * (flat * flat * flat);
  }

  // A whole turn, in radians.
  static constexpr Real kTwoPi = static_cast<Real>(6.283185307179586476925286766559);
};

// How steep a curve may be, as |dy/dx|, where a line may be as steep as `steepest`, at least 0. The straight
// end of a curve is 1/4 px long, and leads up to 1/512 px beside the curve, in x and in y.
template <class Real>
constexpr Real steepest_on_curve(Real steepest) {
  return steepest + (1 + steepest) * (1 + steepest) / 128;
}

// A line, a stretch of a curve or a wall. A terrain makes them; a caller only reads them.
//
// Ends: x0 <= x1. A wall has x0 == x1 and y0 <= y1; a wall without height is the tip of a wedge.
//
// A line is y = base_y + (x - base_x) * slope. The base is the upper end of the whole slope that the piece
// was cut from, so that its pieces lie on one line, and a mirrored one has the mirrored bits.
//
// An end is convex if the outline turns away from the open side there: a floor's end that a box can stand on
// with only its bottom side, or a wall's end that a box can pass by. An end is last if no floor goes on
// there. The end of a solid floor is covered if only lines that bodies from below pass rise from it: what is
// under such a line stands on the end. It is last, too, as those do not count. An end of a piece in several
// cells is far if it is outside of the cell of this copy: the copy that has the end in its cell knows what is
// around it, and is the only one that stops a box there.
template <class Real>
struct Piece {
  Real x0 = 0;                 // px, of the first end
  Real y0 = 0;                 // px, of the first end
  Real x1 = 0;                 // px, of the second end
  Real y1 = 0;                 // px, of the second end
  Real base_x = 0;             // px, of the base
  Real base_y = 0;             // px, of the base
  Real slope = 0;              // dy/dx of a line
  Real slope_rest = 0;         // what rounding took from the slope
  std::int32_t origin = 0;     // for a tile's shape, its cell as y * width + x; for a curve, -1 - its number
  std::uint32_t stretch = 0;   // 1 + the number of the curve's stretch; 0: a line or a wall
  Facing facing = Facing::up;  // the side that stops bodies
  bool convex0 : 1 = false;    // the first end is convex
  bool convex1 : 1 = false;    // the second end is convex
  bool last0 : 1 = false;      // the first end is last
  bool last1 : 1 = false;      // the second end is last
  bool one_way : 1 = false;    // bodies that come from behind pass it
  bool far0 : 1 = false;       // the first end is far
  bool far1 : 1 = false;       // the second end is far
  bool covered0 : 1 = false;   // the first end is covered
  bool covered1 : 1 = false;   // the second end is covered

  bool rises_to_the_right() const { return y1 < y0; }  // its second end is the higher one
  bool is_wall() const { return facing == Facing::left || facing == Facing::right; }  // it is vertical

  bool is_open0() const { return convex0 || far0; }  // a box beside the first end passes it
  bool is_open1() const { return convex1 || far1; }  // a box beside the second end passes it

  // px: the height at x, px, clamped to the piece. stretches: those of its terrain.
  Real y_at(Real x, std::span<const CurveStretch<Real>> stretches) const {
    if (x <= x0) return y0;
    if (x >= x1) return y1;
    const Real y = stretch != 0 ? stretches[stretch - 1].y_at(x) : line_at(x);
    return std::clamp(y, std::min(y0, y1), std::max(y0, y1));
  }

  // The point from which the line's height at x is computed. A free line is whole, and uses its nearer end,
  // which halves the rounding.
  BasicVec2<Real> base_near(Real x) const {
    const bool is_base0 = base_x == x0;
    const Real other_x = is_base0 ? x1 : x0;
    if (origin >= 0 || std::abs(x - base_x) <= std::abs(x - other_x)) return {base_x, base_y};
    return {other_x, is_base0 ? y1 : y0};
  }
  // px: the height of the line at x, px, which may be beyond its ends.
  Real line_at(Real x) const {
    const BasicVec2<Real> base = base_near(x);
    return base.y + (x - base.x) * slope;
  }
};

}  // namespace talus
