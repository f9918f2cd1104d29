// Casts a box through a terrain: when and where does it first meet the outline?
#pragma once

#include <limits>

#include "terrain.h"

namespace talus {

template <class Real>
struct Contact {
  Real t = std::numeric_limits<Real>::infinity();  // time of impact, 0..1 of the motion; infinite: none
  BasicVec2<Real> position;                        // of the box then, its top-left corner, on what it hit
  BasicVec2<Real> normal;                          // unit, out of the ground
  Facing facing = Facing::up;
  std::int32_t origin = 0;             // as Piece::origin; -1 - index of one of `others`
  const Piece<Real>* piece = nullptr;  // what it hit; null: a full tile, or one of `others`
  bool is_other = false;               // one of `others`
  bool on_end = false;                 // a flat side of the box met the end of the piece, not its line
  explicit operator bool() const { return t <= 1; }
};

// A moving box. Every piece stops only what comes from the side that it faces; a box that is further behind
// one than rounding_slack() goes through it, so a box that starts inside of the ground can leave.
template <class Real>
struct Cast {
  BasicRect<Real> box;     // px
  BasicVec2<Real> motion;  // px
  Foot foot = Foot::box;   // what of the box stands on floors: the whole bottom, or its centre alone
};

// What is no box or too far away meets nothing: see is_usable(). No terrain comes near these limits.
inline constexpr double kMaxCastSize = 1 << 26;             // px, of a box in x and in y
inline constexpr double kMaxCastReach = double(1LL << 40);  // px, sum of all coordinates and sizes

// What a few roundings may have made of a number, of its size.
template <class Real>
inline constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();

// Whether the motion is large enough to move the box at all; a smaller one counts as none.
template <class Real>
bool moves_sideways(const Cast<Real>& cast) {
  return moved_x(cast.box, cast.motion.x) != cast.box.x;
}

// A few units in the last place of the coordinates involved: what rounding may have put a box into the
// ground. Alike for mirror images, and for all motions of up to two cells.
template <class Real>
[[gnu::always_inline]] inline Real rounding_slack(const Cast<Real>& cast) {
  const BasicRect<Real>& b = cast.box;
  const Real half_w = b.w / 2, half_h = b.h / 2;
  const Real reach = (std::abs(b.x + half_w) + half_w) + (std::abs(b.y + half_h) + half_h) +
                     std::max(std::abs(cast.motion.x) + std::abs(cast.motion.y), Real(2 * kTileSide));
  return reach * kRounding<Real>;
}

// Whether a box can be cast: its sizes are 0 to kMaxCastSize, and all numbers finite and within
// kMaxCastReach.
template <class Real>
bool is_usable(const Cast<Real>& cast) {
  const BasicRect<Real>& b = cast.box;
  constexpr Real most = Real(kMaxCastSize);
  return b.w >= 0 && b.w <= most && b.h >= 0 && b.h <= most &&
         rounding_slack(cast) <= Real(kMaxCastReach) * kRounding<Real>;
}

// What a cast may look at, for callers that cannot wait for a long one: each slice of a long way counts 1,
// each piece of the outline and each other box as well.
struct CastBudget {
  std::int64_t left = std::numeric_limits<std::int64_t>::max();
  // Share of the last cast's motion that was looked at. Less than 1: the budget was used up there; nothing is
  // met before, and what comes after is not known.
  double seen = 1;
};

// The first contact. Between contacts at the same time the most opposing one counts, then the one more level;
// two mirror images count as one that faces straight up or down. A corner that is aimed at exactly counts as
// a floor or ceiling. `ignored`: a piece that stops nothing this time.
// `others`: boxes that stop it as tiles do. None for a cast that is not usable. budget: null: none.
template <class Real>
Contact<Real> cast_box(const BasicTerrain<Real>& terrain, const Cast<Real>& cast,
                       std::span<const BasicRect<Real>> others = {}, const Piece<Real>* ignored = nullptr,
                       CastBudget* budget = nullptr);

// How far right of a box's left side the part of it is that touches a sloped floor or ceiling.
template <class Real>
Real foot_offset(const Piece<Real>& piece, Real width, Foot foot) {
  const bool up = piece.facing == Facing::up;
  if (up && foot == Foot::centre) return width / 2;
  return piece.rises_to_the_right() == up ? width : 0;
}

// Whether a rounding of x is worth more than one of y there. Not told of curves.
template <class Real>
bool is_steep(const Piece<Real>& piece) {
  return std::abs(piece.slope) > 1;
}

// Where the top of a box at x rests on the piece, box.y being of no matter.
template <class Real>
Real rest_on(const Piece<Real>& piece, std::span<const CurveStretch<Real>> stretches,
             const BasicRect<Real>& box, Foot foot);

// box.x moved by dx, and rounded so that both its sides are exact; a mirrored box goes to the mirrored place.
template <class Real>
inline Real moved_x(const BasicRect<Real>& box, Real dx) {
  if (dx == 0) return box.x;
  const Real center = box.x + box.w / 2 + dx;
  const Real left = center - box.w / 2, right = center + box.w / 2;
  return std::abs(right) > std::abs(left) ? right - box.w : left;
}

}  // namespace talus
