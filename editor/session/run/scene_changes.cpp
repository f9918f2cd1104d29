// Which changes of a level the simulation sees.
#include "scene_changes.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include <talus/sim/scene.h>

namespace talus {
namespace {

// Whether tiles with these flags are the same to the simulation.
bool same_physics(const Level& level, FlagSet flags_a, FlagSet flags_b) {
  return role_of(flags_a, level.roles) == role_of(flags_b, level.roles) &&
         shape_of_flags(level, flags_a) == shape_of_flags(level, flags_b);
}

// Whether layers differ at most in their looks.
bool same_ground(const TileLayers& a, const TileLayers& b) {
  const auto same = [](const TileLayer& x, const TileLayer& y) {
    return x.is_ground == y.is_ground && x.cells == y.cells;
  };
  const auto same_place = [](const LayerGroup& x, const LayerGroup& y) {
    return x.group == y.group && x.offset == y.offset;
  };
  return a.chosen == b.chosen &&
         std::equal(a.list.begin(), a.list.end(), b.list.begin(), b.list.end(), same) &&
         std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(), same_place);
}

// Whether two bodies differ in their names and pictures alone.
bool move_alike(const Spawn& a, const Spawn& b) {
  return a.position == b.position && a.velocity == b.velocity && a.kind == b.kind && a.size == b.size &&
         a.foot == b.foot;
}

// Whether the simulation can see a change. Painting pixels, or one plain tile over another, must not cost a
// compilation.
bool changes_scene(const Level& level, const Change& change) {
  return std::visit(
      [&](const auto& c) {
        using T = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<T, CellChange>) {
          const TileNumber before = c.before.tile, after = c.after.tile;
          return level.tile_shapes[before] != level.tile_shapes[after] ||
                 !same_physics(level, level.tile_flags(before), level.tile_flags(after)) ||
                 (c.before.turn != c.after.turn &&
                  shape_of_cell(level, c.before) != shape_of_cell(level, c.after));
        } else if constexpr (std::is_same_v<T, FlagsChange>) {
          return c.sheet == SheetId::tiles && !same_physics(level, c.before, c.after);
        } else if constexpr (std::is_same_v<T, SpawnsChange>) {
          return !std::equal(c.before.begin(), c.before.end(), c.after.begin(), c.after.end(), move_alike);
        } else if constexpr (std::is_same_v<T, LayersChange>) {
          return !same_ground(c.before, c.after);
        } else {
          return !(std::is_same_v<T, PixelChange> || std::is_same_v<T, TileLookChange> ||
                   std::is_same_v<T, ColorChange> || std::is_same_v<T, BackgroundChange> ||
                   std::is_same_v<T, FlagNameChange> || std::is_same_v<T, FlagFieldsChange> ||
                   std::is_same_v<T, BrushesChange> || std::is_same_v<T, AutoTilesChange> ||
                   std::is_same_v<T, ExportsChange> || std::is_same_v<T, TilesetsChange> ||
                   std::is_same_v<T, TileNotesChange> || std::is_same_v<T, TileAnimationsChange>);
        }
      },
      change);
}

}  // namespace

void SceneChanges::add(const Level& level, const Change& change) {
  if (!changes_scene(level, change)) return;
  const auto* cell = std::get_if<CellChange>(&change);
  const auto* tuning = std::get_if<TuningChange>(&change);
  if (std::holds_alternative<SpawnsChange>(change) ||
      (tuning != nullptr && is_same_ground(tuning->before, tuning->after))) {
    bodies = true;
    return;
  }
  whole = whole || cell == nullptr || cells.size() >= kMaxCells;
  if (cell != nullptr && !whole) cells.push_back(cell->cell);
}

}  // namespace talus
