#include "layers_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {
namespace {

// Whether a level cannot have them, since there are too many, or too many in one another.
bool are_too_many(const LayerGroups& groups) {
  std::vector<int> depths;
  for (const LayerGroup& group : groups)
    depths.push_back(group.group < 0 ? 1 : depths[static_cast<std::size_t>(group.group)] + 1);
  return groups.size() > kMaxLayerGroups ||
         std::any_of(depths.begin(), depths.end(), [](int depth) { return depth > kMaxGroupDepth; });
}

}  // namespace

double in_range(double value, double least, double most, double before) {
  return std::isnan(value) ? before : std::clamp(value, least, most);
}

Vec2 in_range(Vec2 value, double most, Vec2 before) {
  return {in_range(value.x, -most, most, before.x), in_range(value.y, -most, most, before.y)};
}

TileLayer copy_of_layer(const Level& level, int layer) {
  TileLayer copy = level.layers.list[static_cast<std::size_t>(layer)];
  if (copy.cells == nullptr) copy.cells = std::make_shared<const MapCells>(level.map.cells());
  return copy;
}

Edit layers_edit(const Level& level, std::string label, TileLayers after, std::vector<ObjectLayer> others) {
  tidy_groups(after, others);
  Edit edit{std::move(label), {}};
  if (are_too_many(after.groups)) return edit;
  edit.layer = level.layers.chosen;
  TileLayer& chosen = after.list[static_cast<std::size_t>(after.chosen)];
  const std::shared_ptr<const MapCells> cells = std::exchange(chosen.cells, nullptr);
  if (cells != nullptr) {  // another one than before: its cells come into the map
    const auto left = std::find_if(after.list.begin(), after.list.end(), [&](const TileLayer& other) {
      return &other != &chosen && other.cells == nullptr;
    });
    if (left != after.list.end()) left->cells = std::make_shared<const MapCells>(level.map.cells());
  }
  if (others != level.objects) edit.changes.emplace_back(ObjectsChange{level.objects, std::move(others)});
  if (after != level.layers) edit.changes.emplace_back(LayersChange{level.layers, std::move(after)});
  if (cells == nullptr || *cells == level.map.cells()) return edit;
  TileMap map = level.map;
  map.cells() = *cells;
  edit.changes.emplace_back(MapChange{level.map, std::move(map)});
  return edit;
}

std::vector<LayerEntry> layer_entries(const Level& level) {
  std::vector<LayerEntry> entries;
  for (const LayerInOrder& layer : layers_in_order(level))
    entries.push_back({layer, group_of(level, layer), false});
  return entries;
}

Edit layers_edit(const Level& level, std::string label, const std::vector<LayerEntry>& entries,
                 LayerGroups groups) {
  const auto count = std::count_if(entries.begin(), entries.end(),
                                   [](const LayerEntry& entry) { return entry.layer.has_tiles; });
  TileLayers after = level.layers;
  after.list.clear();
  after.groups = std::move(groups);
  after.chosen = -1;
  int behind_chosen = 0;  // how many layers of tiles are behind the chosen one, if it goes
  std::vector<ObjectLayer> others;
  for (const auto& [layer, group, is_copy] : entries) {
    if (layer.has_tiles) {
      if (layer.index < level.layers.chosen) behind_chosen = after.count();
      if (layer.index == level.layers.chosen && !is_copy) after.chosen = after.count();
      after.list.push_back(is_copy ? copy_of_layer(level, layer.index)
                                   : level.layers.list[static_cast<std::size_t>(layer.index)]);
      after.list.back().group = group;
      continue;
    }
    ObjectLayer& other = others.emplace_back(level.objects[static_cast<std::size_t>(layer.index)]);
    other.group = group;
    const bool stays_in_front = other.place == kInFront && after.count() == count;
    if (!stays_in_front) other.place = after.count();
  }
  if (after.chosen < 0) after.chosen = behind_chosen;
  return layers_edit(level, std::move(label), std::move(after), std::move(others));
}

}  // namespace talus
