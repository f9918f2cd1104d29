// Applies, reverts and merges edits.
#include "edit.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

#include <talus/level/limits.h>

namespace talus {

Change::Change(const Change&) = default;
Change::Change(Change&&) noexcept = default;
Change& Change::operator=(const Change&) = default;
Change& Change::operator=(Change&&) noexcept = default;
Change::~Change() = default;

namespace {

// The place in a level that a change is about. L is Level or const Level.
template <class L>
auto& place(L& level, const PixelChange& c) {
  return level.sheet(c.sheet).images[c.tile][c.pixel];
}
template <class L>
auto& place(L& level, const FlagsChange& c) {
  return level.sheet(c.sheet).flags[c.tile];
}
template <class L>
auto& place(L& level, const ColorChange& c) {
  return level.palette[c.color];
}
template <class L>
auto& place(L& level, const BackgroundChange&) {
  return level.background;
}
template <class L>
auto& place(L& level, const FlagNameChange& c) {
  return level.flag_names[c.flag];
}
template <class L>
auto& place(L& level, const FlagFieldsChange&) {
  return level.flag_fields;
}
template <class L>
auto& place(L& level, const RolesChange&) {
  return level.roles;
}
template <class L>
auto& place(L& level, const TileShapeChange& c) {
  return level.tile_shapes[c.tile];
}
template <class L>
auto& place(L& level, const TileNotesChange&) {
  return level.tile_notes;
}
template <class L>
auto& place(L& level, const TileAnimationsChange&) {
  return level.animations;
}
template <class L>
auto& place(L& level, const FlagShapeChange& c) {
  return level.flag_shapes[c.flag];
}
template <class L>
auto& place(L& level, const CurvesChange&) {
  return level.curves;
}
template <class L>
auto& place(L& level, const ObjectsChange&) {
  return level.objects;
}
template <class L>
auto& place(L& level, const TuningChange&) {
  return level.tuning;
}
template <class L>
auto& place(L& level, const SpawnsChange&) {
  return level.spawns;
}
template <class L>
auto& place(L& level, const BrushesChange&) {
  return level.brushes;
}
template <class L>
auto& place(L& level, const AutoTilesChange&) {
  return level.auto_tiles;
}
template <class L>
auto& place(L& level, const ExportsChange&) {
  return level.exports;
}
template <class L>
auto& place(L& level, const TilesetsChange&) {
  return level.tilesets;
}
template <class L>
auto& place(L& level, const LayersChange&) {
  return level.layers;
}
template <class L>
auto& place(L& level, const LevelChange&) {
  return level;
}
template <class L>
auto& place(L& level, const MapChange&) {
  return level.map;
}

// What a level holds at the place of a change.
template <class C>
const auto& value_at(const Level& level, const C& c) {
  return place(level, c);
}
MapCell value_at(const Level& level, const CellChange& c) { return level.map.at(c.cell); }
TileLook value_at(const Level& level, const TileLookChange& c) {
  return look_of(level.sheet(c.sheet), level.map.tile_size(), c.tile);
}

template <class C, class Value>
void put_value(Level& level, const C& c, const Value& value) {
  place(level, c) = value;
}
void put_value(Level& level, const CellChange& c, MapCell cell) { level.map.set(c.cell, cell); }
void put_value(Level& level, const TileLookChange& c, const TileLook& look) {
  put_look(look, level.map.tile_size(), c.tile, level.sheet(c.sheet));
}

// A number that differs for two places of the same kind; fits 56 bits.
std::uint64_t number(const CellChange& c) {
  return static_cast<std::uint64_t>(c.cell.y) * kMaxTerrainSide + c.cell.x;
}
std::uint64_t number(const PixelChange& c) {
  const int image = static_cast<int>(c.sheet) * kMaxTiles + c.tile;
  return static_cast<std::uint64_t>(image) * kCartTileSize * kCartTileSize + c.pixel;
}
std::uint64_t number(const TileLookChange& c) {
  return static_cast<std::uint64_t>(static_cast<int>(c.sheet) * kMaxTiles + c.tile);
}
std::uint64_t number(const FlagsChange& c) {
  return static_cast<std::uint64_t>(static_cast<int>(c.sheet) * kMaxTiles + c.tile);
}
std::uint64_t number(const ColorChange& c) { return static_cast<std::uint64_t>(c.color); }
std::uint64_t number(const FlagNameChange& c) { return static_cast<std::uint64_t>(c.flag); }
std::uint64_t number(const TileShapeChange& c) { return static_cast<std::uint64_t>(c.tile); }
std::uint64_t number(const FlagShapeChange& c) { return static_cast<std::uint64_t>(c.flag); }
template <class OneOfAKind>
std::uint64_t number(const OneOfAKind&) {
  return 0;
}

std::uint64_t place_key(const Change& change) {
  const std::uint64_t within = std::visit([](const auto& c) { return number(c); }, change);
  return static_cast<std::uint64_t>(change.index()) << 56 | within;
}

// The key of MapChange, of which an edit has one at most.
constexpr std::size_t kMapIndex = std::variant_size_v<AnyChange> - 1;
static_assert(std::is_same_v<std::variant_alternative_t<kMapIndex, AnyChange>, MapChange>);
constexpr std::uint64_t kMapKey = std::uint64_t{kMapIndex} << 56;

// Whether a level has the place of a change, and can hold what comes there.
template <class C>
bool fits(const Level& level, const C& c) {
  if constexpr (std::is_same_v<C, CellChange>) {
    return level.map.contains(c.cell) && c.after.tile < level.tile_count();
  } else if constexpr (std::is_same_v<C, PixelChange>) {  // a picture in true colour hides the pixels
    return c.tile < level.sheet(c.sheet).count() && level.sheet(c.sheet).picture == nullptr;
  } else if constexpr (std::is_same_v<C, TileLookChange>) {
    const TileSize size = level.map.tile_size();
    const auto bytes = static_cast<std::size_t>(4 * size.width * size.height);
    return c.tile < level.sheet(c.sheet).count() && level.sheet(c.sheet).picture != nullptr &&
           c.after.rgba.size() == bytes;
  } else if constexpr (std::is_same_v<C, FlagsChange>) {
    return c.tile < level.sheet(c.sheet).count();
  } else if constexpr (std::is_same_v<C, TileShapeChange>) {
    return c.tile < level.tile_count();
  } else if constexpr (std::is_same_v<C, TileNotesChange> || std::is_same_v<C, TileAnimationsChange>) {
    return !problem_of(c.after, level.tile_count());
  } else if constexpr (std::is_same_v<C, TilesetsChange>) {
    return !problem_of(c.after, level.sheet(SheetId::tiles).layout());
  } else if constexpr (std::is_same_v<C, LayersChange>) {
    return c.before.chosen == level.layers.chosen;
  } else {
    return true;
  }
}

bool is_no_change(const Change& change) {
  return std::visit([](const auto& c) { return c.before == c.after; }, change);
}

// Whether a change adds to something that has a limit in a level.
template <class C>
constexpr bool kIsCounted = std::is_same_v<C, FlagNameChange> || std::is_same_v<C, FlagFieldsChange> ||
                            std::is_same_v<C, CurvesChange> || std::is_same_v<C, ObjectsChange> ||
                            std::is_same_v<C, SpawnsChange> || std::is_same_v<C, BrushesChange> ||
                            std::is_same_v<C, ExportsChange> || std::is_same_v<C, TilesetsChange> ||
                            std::is_same_v<C, TileShapeChange> || std::is_same_v<C, LayersChange> ||
                            std::is_same_v<C, TileNotesChange> || std::is_same_v<C, TileAnimationsChange>;

// The parts of a level that problem_of_amounts counts.
Level counted_part(const Level& level) {
  Level part;
  part.map = TileMap(1, 1);
  part.flag_names = level.flag_names;
  part.flag_fields = level.flag_fields;
  part.curves = level.curves;
  part.spawns = level.spawns;
  part.tile_shapes = level.tile_shapes;
  part.layers = level.layers;
  part.brushes = level.brushes;
  part.exports = level.exports;
  part.tilesets = level.tilesets;
  part.tile_notes = level.tile_notes;
  part.animations = level.animations;
  part.extra = level.extra;
  return part;
}

std::size_t memory_of(const MapCells& cells) {
  return cells.size() * sizeof(TileNumber) + cells.turns().size() * sizeof(TileTurn);
}

// The memory of the cells that one of the lists does not share with the other.
std::size_t memory_of_cells(const TileLayers& layers, const TileLayers& other) {
  std::size_t bytes = layers.list.size() * sizeof(TileLayer);
  for (const TileLayer& layer : layers.list) {
    const auto is_same = [&](const TileLayer& its) { return its.cells == layer.cells; };
    if (layer.cells != nullptr && std::none_of(other.list.begin(), other.list.end(), is_same))
      bytes += memory_of(*layer.cells);
  }
  return bytes;
}

// The memory of a change besides its own size.
template <class C>
std::size_t memory_behind(const C& change) {
  if constexpr (std::is_same_v<C, MapChange>) {
    return memory_of(change.before.cells()) + memory_of(change.after.cells());
  } else if constexpr (std::is_same_v<C, LevelChange>) {
    return 2 * sizeof(Level) + size_of(change.before) + size_of(change.after);
  } else if constexpr (std::is_same_v<C, TileLookChange>) {
    return change.before.rgba.size() + change.after.rgba.size();
  } else if constexpr (std::is_same_v<C, TileShapeChange>) {
    return (change.before.heights.size() + change.after.heights.size()) * sizeof(double);
  } else if constexpr (std::is_same_v<C, LayersChange>) {
    return memory_of_cells(change.before, change.after) + memory_of_cells(change.after, change.before);
  } else if constexpr (kIsCounted<C>) {
    Level before, after;
    before.map = after.map = TileMap(1, 1);  // map and tiles are not part of the change
    before.set_tile_layout({1, 1});
    after.set_tile_layout({1, 1});
    place(before, change) = change.before;
    place(after, change) = change.after;
    return size_of(before) + size_of(after);
  }
  return 0;
}

}  // namespace

std::optional<std::string> problem_after(const Level& level, const Edit& edit) {
  // Without the parts that have no limits; empty: the change does not affect parts that have one.
  std::optional<Level> after;
  for (const Change& change : edit.changes) {
    std::visit(
        [&]<class C>(const C& c) {
          if constexpr (std::is_same_v<C, LevelChange>) after = counted_part(c.after);
          if constexpr (kIsCounted<C>) {
            if (!after) after = counted_part(level);
            place(*after, c) = c.after;
          }
        },
        change);
  }
  return after ? problem_of_amounts(*after) : std::nullopt;
}

std::size_t memory_of(const Edit& edit) {
  std::size_t bytes = sizeof(Edit) + edit.label.size();
  for (const Change& change : edit.changes)
    bytes += sizeof(Change) + std::visit([](const auto& c) { return memory_behind(c); }, change);
  return bytes;
}

Edit replace_by(const Level& level, std::shared_ptr<const Level> other, std::string label) {
  Edit edit{std::move(label), {}};
  if (level != *other) edit.changes.emplace_back(LevelChange{level, LevelCopy(std::move(other))});
  return edit;
}

int layer_after(const Edit& edit) {
  int layer = edit.layer;
  for (const Change& change : edit.changes) {
    if (const auto* layers = std::get_if<LayersChange>(&change)) layer = layers->after.chosen;
    if (const auto* whole = std::get_if<LevelChange>(&change))
      layer = static_cast<const Level&>(whole->after).layers.chosen;
  }
  return layer;
}

void apply_edit(Level& level, const Edit& edit) {
  level.choose_layer(edit.layer);
  for (const Change& change : edit.changes) {
    std::visit(
        [&](const auto& c) {
          assert(value_at(level, c) == c.before);
          put_value(level, c, c.after);
        },
        change);
  }
}

void revert_edit(Level& level, const Edit& edit) {
  level.choose_layer(layer_after(edit));
  std::for_each(edit.changes.rbegin(), edit.changes.rend(), [&](const Change& change) {
    std::visit(
        [&](const auto& c) {
          assert(value_at(level, c) == c.after);
          put_value(level, c, c.before);
        },
        change);
  });
}

void rebase_edit(const Level& level, Edit& edit) {
  edit.layer = level.layers.chosen;
  std::erase_if(edit.changes, [&](Change& change) {
    if (!std::visit([&](const auto& c) { return fits(level, c); }, change)) return true;
    return std::visit(
        [&](auto& c) {
          const auto& value = value_at(level, c);
          if (c.before != value) c.before = value;
          return c.before == c.after;
        },
        change);
  });
}

void merge_edit(Edit& edit, const Edit& next) { EditMerger(edit).merge(edit, next); }

EditMerger::EditMerger(const Edit& edit) {
  index_of_place_.reserve(edit.changes.size());
  for (std::size_t i = 0; i < edit.changes.size(); ++i) index_of_place_[place_key(edit.changes[i])] = i;
}

void EditMerger::merge(Edit& edit, const Edit& next) {
  assert(layer_after(edit) == next.layer);
  for (const Change& change : next.changes) merge_change(edit, change);
  if (edit.selection && next.selection)
    edit.selection->after = next.selection->after;
  else if (next.selection)
    edit.selection = next.selection;
  // Checked once, not for each cell that was folded into it: comparing maps is expensive.
  const auto map = index_of_place_.find(kMapKey);
  if (map != index_of_place_.end() && is_no_change(edit.changes[map->second])) remove(edit, map->second);
}

void EditMerger::merge_change(Edit& edit, const Change& next) {
  const auto map = index_of_place_.find(kMapKey);
  const bool has_map = map != index_of_place_.end();
  if (const CellChange* cell = std::get_if<CellChange>(&next); cell != nullptr && has_map) {
    std::get<MapChange>(edit.changes[map->second]).after.set(cell->cell, cell->after);
    return;
  }
  if (const MapChange* whole = std::get_if<MapChange>(&next); whole != nullptr && !has_map) {
    fold_cells_into_map(edit, *whole);
    return;
  }
  const auto [found, is_new] = index_of_place_.try_emplace(place_key(next), edit.changes.size());
  if (is_new) {
    edit.changes.push_back(next);
    return;
  }
  const std::size_t index = found->second;
  std::visit([&](const auto& c) { std::get<std::decay_t<decltype(c)>>(edit.changes[index]).after = c.after; },
             next);
  if (!std::holds_alternative<MapChange>(next) && is_no_change(edit.changes[index])) remove(edit, index);
}

// Cells and the whole map are one place seen twice, so an edit keeps either cells or the map.
void EditMerger::fold_cells_into_map(Edit& edit, const MapChange& next) {
  MapChange whole = next;
  std::erase_if(edit.changes, [&](const Change& change) {
    const CellChange* cell = std::get_if<CellChange>(&change);
    if (cell != nullptr) whole.before.set(cell->cell, cell->before);
    return cell != nullptr;
  });
  edit.changes.emplace_back(std::move(whole));
  *this = EditMerger(edit);
}

// Places are independent of one another, so the last change may move to the place of the removed one.
void EditMerger::remove(Edit& edit, std::size_t index) {
  index_of_place_.erase(place_key(edit.changes[index]));
  if (index + 1 < edit.changes.size()) {
    edit.changes[index] = std::move(edit.changes.back());
    index_of_place_[place_key(edit.changes[index])] = index;
  }
  edit.changes.pop_back();
}

}  // namespace talus
