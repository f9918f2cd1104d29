#include "ground_level.h"

#include <algorithm>
#include <utility>

#include <talus/level/ground.h>
#include "ground_cells.h"
#include "object_ground.h"

namespace talus {
namespace {

bool fits_layers(const Level& level, const CellChange& change) {
  const bool is_ground = level.layers.list[static_cast<std::size_t>(level.layers.chosen)].is_ground;
  return is_ground && level.map.contains(change.cell) && level.map.at(change.cell) == change.before &&
         change.after.tile < level.tile_count();
}

// own_tiles: the number of tiles that are not made of objects.
Level ground_of_tiles(const Level& level, int own_tiles, GroundNames* names) {
  const GroundCells ground = ground_cells(level);
  if (names != nullptr) *names = GroundNames(own_tiles, level.tile_count(), ground.stacks);
  if (ground.overflow > 0) {
    if (names != nullptr) names->set_problem(ground_problem(level, ground));
    return without_tiles(level);
  }
  Level flat = level;
  flat.layers = {};
  flat.map.cells() = std::vector<TileNumber>(ground.cells.begin(), ground.cells.end());
  if (ground.stacks.empty()) return flat;
  const int count = level.tile_count() + static_cast<int>(ground.stacks.size());
  const int least_columns = (count + kMaxSheetSide - 1) / kMaxSheetSide;
  flat.set_tile_layout({std::max(level.sheet(SheetId::tiles).columns, least_columns), count});
  Sheet& sheet = flat.sheet(SheetId::tiles);
  for (int number = level.tile_count(); number < count; ++number) {
    const auto at = static_cast<std::size_t>(number);
    const TileStack& stack = ground.stacks[at - static_cast<std::size_t>(level.tile_count())];
    flat.tile_shapes[at] = shape_of_number(level, ground.stacks, static_cast<TileNumber>(number));
    if (stack.size() == 1) sheet.images[at] = sheet.images[stack.front().tile];
  }
  return flat;
}

}  // namespace

bool has_plain_ground(const Level& level) {
  return level.layers.count() == 1 && level.layers.list.front().is_ground &&
         !level.map.cells().has_turned() && !has_object_ground(level);
}

Level ground_level(const Level& level, GroundNames* names) {
  if (!has_object_ground(level)) return ground_of_tiles(level, level.tile_count(), names);
  std::optional<std::string> problem;
  Level tiles = with_object_tiles(level, false, &problem);
  tiles.curves = level.curves;  // an edit of them must be one of the level's
  Level ground = ground_of_tiles(tiles, level.tile_count(), names);
  if (names != nullptr && problem) names->set_problem(std::move(problem));
  return ground;
}

bool update_cell(const Level& level, Cell cell, Level& of_ground) {
  if (of_ground.tile_count() != level.tile_count() || has_object_ground(level)) return false;
  const auto number = ground_number(level, {}, cell);
  if (number) of_ground.map.set(cell, *number);
  return number.has_value();
}

bool fits_layers(const Level& level, const Edit& edit) {
  return std::all_of(edit.changes.begin(), edit.changes.end(), [&](const Change& change) {
    if (const auto* cell = std::get_if<CellChange>(&change)) return fits_layers(level, *cell);
    if (const auto* shape = std::get_if<TileShapeChange>(&change)) return shape->tile < level.tile_count();
    if (const auto* flags = std::get_if<FlagsChange>(&change)) return flags->tile < level.tile_count();
    return true;
  });
}

}  // namespace talus
