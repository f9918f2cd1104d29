// Levels are brought to the place of their ground before they are merged.
#include "merge.h"
#include "merge_groups.h"
#include "moved_ground.h"

namespace talus {
namespace {

constexpr const char* kPlace = "the place of the ground";
constexpr const char* kApart = "the ground lies elsewhere there, and no level has room for both";

// Cells that were changed here and are not on the map any more after a shift. moved: cells, by which the
// ground lies elsewhere here than in the base.
int changed_cells_cut_off(const Level& base, const Level& mine, Cell moved, Cell by) {
  if (by.x >= 0 && by.y >= 0) return 0;
  int count = 0;
  for (int layer = 0; layer < mine.layers.count(); ++layer) {
    const int before = matching_layer(mine, layer, base);
    std::size_t i = 0;
    for (Cell c{0, 0}; c.y < mine.map.height(); ++c.y) {
      for (c.x = 0; c.x < mine.map.width(); ++c.x, ++i) {
        if (c.x + by.x >= 0 && c.y + by.y >= 0) continue;
        const Cell old{c.x - moved.x, c.y - moved.y};
        const bool was = before >= 0 && base.map.contains(old);
        const auto at = static_cast<std::size_t>(old.y) * static_cast<std::size_t>(base.map.width()) +
                        static_cast<std::size_t>(old.x);
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

// Whether a level has other columns or rows of its map of Tiled than the base, as after an undone reading:
// it is not the user who moved its ground.
bool begins_elsewhere(const Level& base, const Level& mine) {
  return base.tiled && mine.tiled &&
         (base.tiled->frame.x != mine.tiled->frame.x || base.tiled->frame.y != mine.tiled->frame.y);
}

Cell difference(Cell a, Cell b) { return {a.x - b.x, a.y - b.y}; }

void note_lost_cells(const Level& base, const Level& changed, Cell moved, Cell by, MergedLevel& merged) {
  if (const int count = changed_cells_cut_off(base, changed, moved, by); count > 0) {
    merged.conflicts.push_back(std::to_string(count) + (count == 1 ? " cell" : " cells") +
                               " that the map no longer has");
  }
}

}  // namespace

// The place of the ground is merged first, as the other parts are; then all three levels go there.
MergedLevel merge_levels(const Level& base, const Level& mine, const Level& theirs, MergeSide side) {
  const TileSize grid = base.map.tile_size();
  if (!(mine.map.tile_size() == grid) || !(theirs.map.tile_size() == grid))
    return merge_in_place(base, mine, theirs, side);
  const GroundPlace before = ground_place(base);
  const Cell here = ground_shift(before, mine), there = ground_shift(before, theirs);
  int conflicts = 0;
  const Cell place = begins_elsewhere(base, mine) ? there : pick_side({0, 0}, here, there, side, conflicts);
  const Cell of_mine = difference(place, here), of_theirs = difference(place, there);
  if (!can_shift(base, place) || !can_shift(mine, of_mine) || !can_shift(theirs, of_theirs)) {
    MergedLevel whole{side == MergeSide::mine ? mine : theirs, {kPlace}, kApart};
    whole.level.cart = theirs.cart;
    whole.level.tiled = theirs.tiled;
    whole.level.ldtk = theirs.ldtk;
    return whole;
  }
  const auto moved_level = [](const Level& level, Cell by) {
    return by == Cell{0, 0} ? level : shifted(level, by);
  };
  MergedLevel merged = merge_in_place(moved_level(base, place), moved_level(mine, of_mine),
                                      moved_level(theirs, of_theirs), side);
  if (conflicts > 0) merged.conflicts.emplace_back(kPlace);
  note_lost_cells(base, mine, here, of_mine, merged);
  note_lost_cells(base, theirs, there, of_theirs, merged);
  return merged;
}

}  // namespace talus
