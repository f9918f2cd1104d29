// The path of a box that moves straight, in cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <talus/collision/shape.h>

namespace talus {

inline constexpr int kSliceTiles = 2;

// px; longer motions are cut into slices of this length, so that only cells near the way are looked at.
inline int slice_length(TileSize tile) { return kSliceTiles * std::min(tile.width, tile.height); }

// A range of cells, both ends included.
struct CellSpan {
  int first, last;
  bool contains(int i) const { return first <= i && i <= last; }
};

// Sets the bits from the first to the last. Bits outside a word are left out.
inline std::uint64_t bits_between(int first, int last) {
  if (last < 0 || first > 63) return 0;
  return (~std::uint64_t{0} >> (63 - std::min(last, 63))) & (~std::uint64_t{0} << std::max(first, 0));
}

// Shortens from..to to the time during which one axis of a box is within 0..limit, and `slack` px of the way
// before and after it. A result with to < from means never.
template <class Real>
void clip_to_map(Real at, Real size, Real motion, Real limit, Real slack, Real& from, Real& to) {
  if (motion == 0) {
    if (at > limit || at + size < 0) to = -1;
    return;
  }
  const Real a = (0 - (at + size)) / motion, b = (limit - at) / motion;
  const Real margin = slack / std::abs(motion);
  from = std::max(from, std::min(a, b) - margin);
  to = std::min(to, std::max(a, b) + margin);
}

}  // namespace talus
