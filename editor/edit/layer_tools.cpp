// Edits of the layers.
#include "layer_tools.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "level/single_change.h"

namespace talus {
namespace {

using Cells = std::vector<TileNumber>;

bool has_layer(const Level& level, int layer) { return layer >= 0 && layer < level.layers.count(); }

TileLayer& layer_at(TileLayers& layers, int index) { return layers.list[static_cast<std::size_t>(index)]; }

std::shared_ptr<const Cells> shared_cells(Cells cells) {
  return std::make_shared<const Cells>(std::move(cells));
}

// The edit to these layers. In them, the layer that was chosen has no cells, if it is still there.
Edit edit_to(const Level& level, std::string label, TileLayers after) {
  Edit edit{std::move(label), {}};
  edit.layer = level.layers.chosen;
  TileLayer& chosen = layer_at(after, after.chosen);
  const std::shared_ptr<const Cells> cells = std::exchange(chosen.cells, nullptr);
  if (cells != nullptr) {  // another one than before: its cells come into the map
    const auto left = std::find_if(after.list.begin(), after.list.end(), [&](const TileLayer& other) {
      return &other != &chosen && other.cells == nullptr;
    });
    if (left != after.list.end()) left->cells = shared_cells(level.map.cells());
  }
  if (after != level.layers) edit.changes.emplace_back(LayersChange{level.layers, std::move(after)});
  if (cells == nullptr || *cells == level.map.cells()) return edit;
  TileMap map = level.map;
  map.cells() = *cells;
  edit.changes.emplace_back(MapChange{level.map, std::move(map)});
  return edit;
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

double within(double value, double most, double before) {
  return std::isnan(value) ? before : std::clamp(value, -most, most);
}

Vec2 within(Vec2 value, double most, Vec2 before) {
  return {within(value.x, most, before.x), within(value.y, most, before.y)};
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
  added.cells = shared_cells(Cells(level.map.cells().size()));
  insert_layer(after, ++after.chosen, std::move(added));
  return edit_to(level, "Add layer", std::move(after));
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
  return edit_to(level, label, std::move(after));
}

Edit remove_layer(const Level& level, int layer) {
  const std::string label = "Delete layer";
  if (!has_layer(level, layer) || level.layers.count() == 1) return {label, {}};
  TileLayers after = level.layers;
  after.list.erase(after.list.begin() + layer);
  if (after.chosen > layer || (after.chosen == layer && layer > 0)) --after.chosen;
  return edit_to(level, label, std::move(after));
}

Edit merge_layer_down(const Level& level, int layer) {
  const std::string label = "Merge layer down";
  if (!has_layer(level, layer) || layer == 0) return {label, {}};
  Cells merged = level.cells_of(layer - 1);
  const Cells& upper = level.cells_of(layer);
  for (std::size_t i = 0; i < merged.size(); ++i)
    if (upper[i] != 0) merged[i] = upper[i];
  TileLayers after = level.layers;
  layer_at(after, layer - 1).cells = shared_cells(std::move(merged));
  after.list.erase(after.list.begin() + layer);
  after.chosen = layer - 1;
  return edit_to(level, label, std::move(after));
}

Edit move_layer(const Level& level, int layer, int to) {
  Edit none{"Move layer", {}};
  if (!has_layer(level, layer) || !has_layer(level, to)) return none;
  TileLayers after = level.layers;
  TileLayer moved = std::move(layer_at(after, layer));
  after.list.erase(after.list.begin() + layer);
  insert_layer(after, to, std::move(moved));
  const int behind = after.chosen - (layer < after.chosen ? 1 : 0);  // without the moved layer
  after.chosen = after.chosen == layer ? to : behind + (to <= behind ? 1 : 0);
  return edit_to(level, none.label, std::move(after));
}

Edit set_layer_looks(const Level& level, int layer, TileLayer looks) {
  if (!has_layer(level, layer)) return {"Change layer", {}};
  TileLayers after = level.layers;
  TileLayer& its = layer_at(after, layer);
  looks.cells = its.cells;
  looks.opacity = std::isnan(looks.opacity) ? its.opacity : std::clamp(looks.opacity, 0.0, 1.0);
  looks.offset = within(looks.offset, kMaxLayerOffset, its.offset);
  looks.parallax = within(looks.parallax, kMaxParallax, its.parallax);
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
  if ((layer.visible && !layer.locked) || !paints_tiles(level, edit)) return std::nullopt;
  const std::string name = "The layer \"" + layer_name(level, chosen) + "\" is ";
  return layer.locked ? name + "locked: unlock it under Layers to paint on it."
                      : name + "hidden: show it under Layers to paint on it.";
}

}  // namespace talus
