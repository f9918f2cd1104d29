// Levels are brought to the place of their ground before they are merged.
#include "merge.h"
#include "moved_ground.h"

namespace talus {
namespace {

// Cells that were changed here and are not on the map any more after a shift.
int changed_cells_cut_off(const Level& base, const Level& mine, Cell by) {
  if (by.x >= 0 && by.y >= 0) return 0;
  int count = 0;
  for (int layer = 0; layer < mine.layers.count(); ++layer) {
    const int before = matching_layer(mine, layer, base);
    std::size_t i = 0;
    for (Cell c{0, 0}; c.y < mine.map.height(); ++c.y) {
      for (c.x = 0; c.x < mine.map.width(); ++c.x, ++i) {
        if (c.x + by.x >= 0 && c.y + by.y >= 0) continue;
        const bool was = before >= 0 && base.map.contains(c);
        const auto at = static_cast<std::size_t>(c.y) * static_cast<std::size_t>(base.map.width()) +
                        static_cast<std::size_t>(c.x);
        if (mine.cells_of(layer)[i] != (was ? base.cells_of(before)[at] : MapCell())) ++count;
      }
    }
  }
  return count;
}

// Whether the map of a level may be larger by so many cells.
bool can_shift(const Level& level, Cell by) {
  return is_terrain_size(level.map.width() + by.x, level.map.height() + by.y, level.map.tile_size());
}

Level shifted(const Level& level, Cell by) {
  return with_moved_ground(level, by, level.map.width() + by.x, level.map.height() + by.y);
}

}  // namespace

MergedLevel merge_levels(const Level& base, const Level& mine, const Level& theirs, MergeSide side) {
  const bool is_same_grid = base.map.tile_size() == theirs.map.tile_size();
  const Cell by = is_same_grid ? ground_shift(ground_place(base), theirs) : Cell{0, 0};
  if (by == Cell{0, 0}) return merge_in_place(base, mine, theirs, side);
  if (!(mine.map.tile_size() == theirs.map.tile_size()) || !can_shift(base, by) || !can_shift(mine, by))
    return {theirs, {"the place of the ground"}};
  MergedLevel merged = merge_in_place(shifted(base, by), shifted(mine, by), theirs, side);
  if (const int count = changed_cells_cut_off(base, mine, by); count > 0) {
    merged.conflicts.push_back(std::to_string(count) + (count == 1 ? " cell" : " cells") +
                               " that the map no longer has");
  }
  return merged;
}

}  // namespace talus
