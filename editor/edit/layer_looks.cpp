#include "layer_looks.h"

#include <utility>

#include "group_tools.h"
#include "layer_tools.h"
#include "level/single_change.h"
#include "object_tools.h"

namespace talus {
namespace {

template <class Layer>
LayerLooks looks_in(const Layer& layer) {
  return {layer.visible, layer.locked, layer.opacity, layer.offset, layer.parallax, layer.tint};
}

template <class Layer>
void put_looks(const LayerLooks& looks, Layer& layer) {
  layer.opacity = looks.opacity;
  layer.offset = looks.offset;
  layer.parallax = looks.parallax;
  layer.tint = looks.tint;
}

std::string label_of(const LayerLooks& before, const LayerLooks& after) {
  if (before.opacity != after.opacity) return "Change a layer's opacity";
  if (before.offset != after.offset) return "Change a layer's offset";
  if (before.parallax != after.parallax) return "Change a layer's parallax";
  return "Change a layer's tint";
}

const ObjectLayer& others_at(const Level& level, int index) {
  return level.objects[static_cast<std::size_t>(index)];
}
const TileLayer& tiles_at(const Level& level, int index) {
  return level.layers.list[static_cast<std::size_t>(index)];
}

}  // namespace

bool has_layer(const Level& level, const LayerInOrder& layer) {
  const int count = layer.has_tiles ? level.layers.count() : static_cast<int>(level.objects.size());
  return layer.index >= 0 && layer.index < count;
}

LayerLooks looks_of(const Level& level, const LayerInOrder& layer) {
  if (!has_layer(level, layer)) return {};
  return layer.has_tiles ? looks_in(tiles_at(level, layer.index)) : looks_in(others_at(level, layer.index));
}

Edit set_looks(const Level& level, const LayerInOrder& layer, const LayerLooks& looks) {
  if (!has_layer(level, layer)) return {"Change layer", {}};
  if (layer.has_tiles) {
    TileLayer tiles = tiles_at(level, layer.index);
    put_looks(looks, tiles);
    return set_layer_looks(level, layer.index, std::move(tiles));
  }
  const LayerLooks before = looks_of(level, layer);
  LayerLooks after = looks;
  keep_in_range(after, before);
  std::vector<ObjectLayer> layers = level.objects;
  put_looks(after, layers[static_cast<std::size_t>(layer.index)]);
  return single_change(label_of(before, after), ObjectsChange{level.objects, std::move(layers)});
}

LayerLooks looks_of_group(const Level& level, int group) {
  const LayerGroups& groups = level.layers.groups;
  const bool is_there = group >= 0 && group < static_cast<int>(groups.size());
  return is_there ? looks_in(groups[static_cast<std::size_t>(group)]) : LayerLooks();
}

Edit set_looks_of_group(const Level& level, int group, const LayerLooks& looks) {
  if (group < 0 || group >= static_cast<int>(level.layers.groups.size())) return {"Change group", {}};
  LayerGroup changed = level.layers.groups[static_cast<std::size_t>(group)];
  put_looks(looks, changed);
  return set_group_looks(level, group, std::move(changed));
}

std::string layer_text(const Level& level, const LayerInOrder& layer) {
  return layer.has_tiles ? layer_name(level, layer.index) : object_layer_text(level, layer.index);
}

}  // namespace talus
