// The visible boxes of a scene's ground.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include <talus/sim/scene.h>
#include "visible.h"

namespace talus {

// Calls visit for each item of a tile, balls included, whose box touches the rectangle. The time depends on
// the size of the rectangle, not of the scene, as items are sorted by column, then row.
template <class Visit>
void for_each_visible_item(const Scene& scene, const Rect& visible, Visit visit) {
  const auto end = std::partition_point(scene.items.begin(), scene.items.end(),
                                        [](const SceneItem& item) { return item.spawn < 0; });
  if (end == scene.items.begin()) return;
  // A box may reach this far beyond its cell.
  const auto cell = [](double px, int side, int margin) {
    return static_cast<int>(std::clamp(std::floor(px / side) + margin, -1.0, double{kMaxTerrainSide}));
  };
  const auto [tile_width, tile_height] = scene.tile_size;
  const int top = cell(visible.y, tile_height, -kMaxShapeTiles);
  const int bottom = cell(visible.bottom(), tile_height, kMaxShapeTiles);
  const int right = std::min(cell(visible.right(), tile_width, 0), std::prev(end)->cell.x);
  const auto before = [](const SceneItem& item, Cell at) {
    return std::tie(item.cell.x, item.cell.y) < std::tie(at.x, at.y);
  };
  auto item = scene.items.begin();
  for (int x = std::max(0, cell(visible.x, tile_width, -kMaxShapeTiles)); x <= right; ++x) {
    item = std::lower_bound(item, end, Cell{x, top}, before);
    if (item == end) return;
    if (item->cell.x > x) {  // skips empty columns at once
      x = item->cell.x - 1;
      continue;
    }
    for (; item != end && item->cell.x == x && item->cell.y <= bottom; ++item)
      if (meet(item->box, visible)) visit(*item);
  }
}

}  // namespace talus
