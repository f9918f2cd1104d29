// The cells of a terrain that a box meets.
#pragma once

#include <algorithm>
#include <cmath>

#include <talus/collision/terrain.h>

namespace talus {

// A range of cells, both ends included.
struct CellBlock {
  int left, top, right, bottom;

  // Those of them that are on the ground.
  template <class Real>
  CellBlock on(const BasicTerrain<Real>& ground) const {
    return {std::max(left, 0), std::max(top, 0), std::min(right, ground.width() - 1),
            std::min(bottom, ground.height() - 1)};
  }
};

// The cells that a box meets, grown by `margin`. Cells just beside the terrain count, those further off do
// not.
template <class Real>
CellBlock cells_met(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Real margin) {
  const auto cell = [](Real at, int side, int count) {
    return static_cast<int>(std::clamp<Real>(std::floor(at / Real(side)), -1, static_cast<Real>(count)));
  };
  const auto column = [&](Real x) { return cell(x, ground.tile_size().width, ground.width()); };
  const auto row = [&](Real y) { return cell(y, ground.tile_size().height, ground.height()); };
  return {column(box.x - margin), row(box.y - margin), column(box.x + box.w + margin),
          row(box.y + box.h + margin)};
}

}  // namespace talus
