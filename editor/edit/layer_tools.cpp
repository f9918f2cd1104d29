// Edits of the layers.
#include "layer_tools.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "layers_edit.h"
#include "level/single_change.h"

namespace talus {
namespace {

bool has_layer(const Level& level, int layer) { return layer >= 0 && layer < level.layers.count(); }

TileLayer& layer_at(TileLayers& layers, int index) { return layers.list[static_cast<std::size_t>(index)]; }

std::shared_ptr<const MapCells> shared_cells(MapCells cells) {
  return std::make_shared<const MapCells>(std::move(cells));
}

using Others = std::vector<ObjectLayer>;

// Those layers in front of the layer of tiles with this index have one more behind them, or one less.
Others with_places(const Level& level, int layer, int by) {
  Others others = level.objects;
  for (ObjectLayer& other : others)
    if (other.place > layer && other.place != kInFront) other.place += by;
  return others;
}

std::string free_layer_name(const Level& level) {
  for (int number = level.layers.count() + 1;; ++number) {
    std::string name = "Layer " + std::to_string(number);
    const bool taken = std::any_of(level.layers.list.begin(), level.layers.list.end(),
                                   [&](const TileLayer& layer) { return layer.name == name; });
    if (!taken) return name;
  }
}

void insert_layer(TileLayers& layers, int at, TileLayer layer) {
  layers.list.insert(layers.list.begin() + at, std::move(layer));
}

// What is done when `before` becomes `after`, by the first difference.
std::string label_of(const TileLayer& before, const TileLayer& after) {
  if (before.name != after.name) return "Rename layer";
  if (before.visible != after.visible) return after.visible ? "Show layer" : "Hide layer";
  if (before.locked != after.locked) return after.locked ? "Lock layer" : "Unlock layer";
  if (before.is_ground != after.is_ground)
    return after.is_ground ? "Make layer ground" : "Make layer scenery";
  if (before.opacity != after.opacity) return "Change a layer's opacity";
  if (before.offset != after.offset) return "Change a layer's offset";
  if (before.parallax != after.parallax) return "Change a layer's parallax";
  return "Change a layer's tint";
}

bool paints_tiles(const Level& level, const Edit& edit) {
  bool paints = false;
  for (const Change& change : edit.changes) {
    // The layers change as such, and not by a tool.
    if (std::holds_alternative<LayersChange>(change) || std::holds_alternative<LevelChange>(change))
      return false;
    const auto* map = std::get_if<MapChange>(&change);
    const bool same_size = map != nullptr && map->after.width() == level.map.width() &&
                           map->after.height() == level.map.height();
    paints = paints || same_size || std::holds_alternative<CellChange>(change);
  }
  return paints;
}

}  // namespace

Edit add_layer(const Level& level) {
  TileLayers after = level.layers;
  TileLayer added;
  added.name = free_layer_name(level);
  added.group = layer_at(after, after.chosen).group;
  added.cells = shared_cells(MapCells(level.map.cells().size()));
  insert_layer(after, ++after.chosen, std::move(added));
  return layers_edit(level, "Add layer", std::move(after), with_places(level, level.layers.chosen, 1));
}

Edit duplicate_layer(const Level& level, int layer) {
  const std::string label = "Duplicate layer";
  if (!has_layer(level, layer)) return {label, {}};
  TileLayers after = level.layers;
  TileLayer copy = layer_at(after, layer);
  copy.name = layer_name(level, layer) + " copy";
  if (copy.cells == nullptr) layer_at(after, layer).cells = shared_cells(level.map.cells());
  insert_layer(after, layer + 1, std::move(copy));
  after.chosen = layer + 1;
  return layers_edit(level, label, std::move(after), with_places(level, layer, 1));
}

Edit remove_layer(const Level& level, int layer) {
  const std::string label = "Delete layer";
  if (!has_layer(level, layer) || level.layers.count() == 1) return {label, {}};
  TileLayers after = level.layers;
  after.list.erase(after.list.begin() + layer);
  if (after.chosen > layer || (after.chosen == layer && layer > 0)) --after.chosen;
  return layers_edit(level, label, std::move(after), with_places(level, layer, -1));
}

Edit merge_layer_down(const Level& level, int layer) {
  const std::string label = "Merge layer down";
  if (!has_layer(level, layer) || layer == 0) return {label, {}};
  MapCells merged = level.cells_of(layer - 1);
  const MapCells& upper = level.cells_of(layer);
  for (std::size_t i = 0; i < merged.size(); ++i)
    if (upper.tiles()[i] != 0) merged.set(i, upper[i]);
  TileLayers after = level.layers;
  layer_at(after, layer - 1).cells = shared_cells(std::move(merged));
  after.list.erase(after.list.begin() + layer);
  after.chosen = layer - 1;
  return layers_edit(level, label, std::move(after), with_places(level, layer, -1));
}

Edit move_layer(const Level& level, int layer, int to) {
  if (!has_layer(level, layer) || !has_layer(level, to)) return {"Move layer", {}};
  const std::vector<LayerInOrder> order = layers_in_order(level);
  const auto place_of = [&](int index) {
    return static_cast<int>(std::find(order.begin(), order.end(), LayerInOrder{true, index}) - order.begin());
  };
  return move_in_order(level, place_of(layer), place_of(to));
}

Edit move_in_order(const Level& level, int from, int to) {
  Edit none{"Move layer", {}};
  std::vector<LayerEntry> entries = layer_entries(level);
  const auto is_place = [&](int place) { return place >= 0 && place < static_cast<int>(entries.size()); };
  if (!is_place(from) || !is_place(to) || from == to) return none;
  const LayerEntry moved = entries[static_cast<std::size_t>(from)];
  entries.erase(entries.begin() + from);
  entries.insert(entries.begin() + to, moved);
  return layers_edit(level, none.label, entries, level.layers.groups);
}

Edit set_layer_looks(const Level& level, int layer, TileLayer looks) {
  if (!has_layer(level, layer)) return {"Change layer", {}};
  TileLayers after = level.layers;
  TileLayer& its = layer_at(after, layer);
  looks.cells = its.cells;
  looks.group = its.group;
  keep_in_range(looks, its);
  std::string label = label_of(its, looks);
  its = std::move(looks);
  Edit edit = single_change(std::move(label), LayersChange{level.layers, std::move(after)});
  edit.layer = level.layers.chosen;
  return edit;
}

std::string layer_name(const Level& level, int layer) {
  const std::string& name = level.layers.list[static_cast<std::size_t>(layer)].name;
  return name.empty() ? "Layer " + std::to_string(layer + 1) : name;
}

std::optional<std::string> problem_of_painting(const Level& level, const Edit& edit) {
  const int chosen = level.layers.chosen;
  const TileLayer& layer = level.layers.list[static_cast<std::size_t>(chosen)];
  const LayerLooks looks = shown_looks(level.layers.groups, layer);
  if ((looks.visible && !looks.locked) || !paints_tiles(level, edit)) return std::nullopt;
  const std::string name = "The layer \"" + layer_name(level, chosen) + "\" is ";
  const bool is_own = looks.locked ? layer.locked : !layer.visible;
  return name + (looks.locked ? "locked: unlock " : "hidden: show ") + (is_own ? "it" : "its group") +
         " under Layers to paint on it.";
}

}  // namespace talus
