// SceneChanges: changes of the level that the simulation has not seen yet.
#pragma once

#include <vector>

#include "level/edit.h"

namespace talus {

struct SceneChanges {
  static constexpr std::size_t kMaxCells = 1000;  // with more, compiling the whole level is as quick

  bool whole = false;       // all of the ground may have changed
  bool bodies = false;      // spawns or tuning, which do not affect the ground
  std::vector<Cell> cells;  // unless `whole`
  bool empty() const { return !whole && !bodies && cells.empty(); }
  // Changes that the simulation cannot see are left out.
  void add(const Level& level, const Change& change);
};

}  // namespace talus
