// Casts a box through a terrain: when and where does it first meet the outline?
#pragma once

#include <limits>
#include <type_traits>

#include <talus/collision/terrain.h>

namespace talus {

// What a cast met first. Without a contact, t is infinite and the other fields have no meaning.
template <class Real>
struct Contact {
  Real t = std::numeric_limits<Real>::infinity();  // time of impact, 0..1 of the motion; infinite: no contact
  BasicVec2<Real> position;            // px, top-left corner of the box at that time, on what it hit
  BasicVec2<Real> normal;              // unit, out of the ground
  Facing facing = Facing::up;          // of the side that it hit
  std::int32_t origin = 0;             // as Piece::origin; -1 - index of one of `others`
  const Piece<Real>* piece = nullptr;  // what it hit; null: a full tile, or one of `others`
  bool is_other = false;               // one of `others`
  bool on_end = false;                 // a flat side of the box met the end of the piece, not its line
  explicit operator bool() const { return t <= 1; }  // whether something was met
};

// A moving box. Every piece stops only what comes from the side that it faces. A box that is further behind a
// piece than a few roundings of its coordinates goes through it, so a box that starts inside of the ground
// can leave.
template <class Real>
struct Cast {
  BasicRect<Real> box;     // px
  BasicVec2<Real> motion;  // px, the whole way; any length
  Foot foot = Foot::box;   // the part of the box that stands on floors: the whole bottom, or only its centre
  // px, from 0 to the box's height, of a box on its centre: the part of its corners that meets no ground, as
  // it is in the floor that the centre walks on. Other boxes stop it.
  Real sunk = 0;
};

// A box with a negative size, with a number that is not finite, or beyond these limits meets nothing. No
// terrain comes near them.
inline constexpr double kMaxCastSize = 1 << 26;             // px, of a box in x and in y
inline constexpr double kMaxCastReach = double(1LL << 40);  // px, sum of all coordinates and sizes

// Limits the work of a cast, for callers that cannot wait long. Each slice of a long motion costs 4, and each
// piece of the outline, side of a tile and other box costs 1.
struct CastBudget {
  std::int64_t left = std::numeric_limits<std::int64_t>::max();  // the work that is left; casts lower it
  // Share of the last cast's motion that was tested. Less than 1: the budget was used up there. Nothing is
  // met before that place; contacts behind it are not known.
  double seen = 1;
};

// Pieces that stop nothing in one cast.
template <class Real>
struct Ignored {
  const Piece<Real>* first = nullptr;             // null: none
  std::span<const Piece<Real>* const> more = {};  // others beside a first one; none of them is null

  Ignored() = default;
  // A piece, and perhaps others, as the two fields.
  Ignored(const Piece<Real>* piece, std::span<const Piece<Real>* const> others = {})
      : first(piece), more(others) {}
};

// The first contact. Of contacts at the same time the most opposing one counts, then the more level one. Two
// mirror images count as one that faces straight up or down. A corner that is aimed at exactly counts as a
// floor or ceiling. `others`: boxes that stop it as tiles do. A box that cannot be cast (see kMaxCastSize)
// has no contact. budget: null: no limit.
template <class Real>
Contact<Real> cast_box(const BasicTerrain<Real>& terrain, const Cast<Real>& cast,
                       std::span<const BasicRect<Real>> others = {},
                       std::type_identity_t<Ignored<Real>> ignored = {}, CastBudget* budget = nullptr);

}  // namespace talus
