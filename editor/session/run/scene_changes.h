// SceneChanges: what has changed in the level that the simulation has not seen yet.
#pragma once

#include <vector>

#include "edit/edit.h"

namespace talus {

struct SceneChanges {
  static constexpr std::size_t kMostCells = 1000;  // beyond that the whole level is compiled no slower

  bool whole = false;       // all of the ground may have changed
  bool bodies = false;      // spawns or tuning, which the ground does not see
  std::vector<Cell> cells;  // unless `whole`
  bool empty() const { return !whole && !bodies && cells.empty(); }
  // What the simulation cannot see is left out.
  void add(const Level& level, const Change& change);
};

}  // namespace talus
