#include "layer_tree.h"

#include <algorithm>

namespace talus {
namespace {

class LayerTree {
 public:
  LayerTree(const Level& level, bool front_first)
      : front_first_(front_first), order_(layers_in_order(level)) {
    for (const LayerInOrder& layer : order_) {
      groups_.push_back(group_of(level, layer));
      chains_.push_back(groups_around(level.layers.groups, groups_.back()));
    }
  }

  std::vector<LayerNode> nodes() {
    add(0, static_cast<int>(order_.size()), 0);
    return std::move(nodes_);
  }

 private:
  int group_at(int layer, int depth) const {
    const std::vector<int>& chain = chains_[static_cast<std::size_t>(layer)];
    return static_cast<std::size_t>(depth) < chain.size() ? chain[static_cast<std::size_t>(depth)] : -1;
  }

  // The layers from `begin` to `end`, which are in so many groups together.
  void add(int begin, int end, int depth) {
    std::vector<LayerNode> here;
    for (int from = begin, to = begin; from < end; from = to) {
      const int group = group_at(from, depth);
      for (++to; group >= 0 && to < end && group_at(to, depth) == group;) ++to;
      const auto at = static_cast<std::size_t>(from);
      here.push_back(group >= 0 ? LayerNode{true, {}, group, depth, from, to}
                                : LayerNode{false, order_[at], groups_[at], depth, from, to});
    }
    if (front_first_) std::reverse(here.begin(), here.end());
    for (const LayerNode& node : here) {
      nodes_.push_back(node);
      if (node.is_group) add(node.begin, node.end, depth + 1);
    }
  }

  bool front_first_;
  std::vector<LayerInOrder> order_;
  std::vector<int> groups_;               // by layer in that order
  std::vector<std::vector<int>> chains_;  // the same, with the groups around
  std::vector<LayerNode> nodes_;
};

template <class Layer>
void put_looks(const LayerLooks& looks, Layer& layer) {
  layer.visible = looks.visible;
  layer.locked = looks.locked;
  layer.opacity = looks.opacity;
  layer.offset = looks.offset;
  layer.parallax = looks.parallax;
  layer.tint = looks.tint;
}

// What a layer or a group in a group looks like without it.
template <class Layer>
void take_looks(const LayerGroup& group, Layer& layer) {
  LayerGroup alone = group;
  alone.group = -1;
  Layer inside = layer;
  inside.group = 0;
  put_looks(shown_looks({alone}, inside), layer);
  layer.group = group.group;
}

}  // namespace

std::vector<LayerNode> layer_tree(const Level& level, bool front_first) {
  return LayerTree(level, front_first).nodes();
}

std::vector<int> groups_around(const LayerGroups& groups, int group) {
  std::vector<int> chain;
  for (int most = static_cast<int>(groups.size()); group >= 0 && group < most;) {
    chain.push_back(group);
    most = group;
    group = groups[static_cast<std::size_t>(group)].group;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

int group_of(const Level& level, LayerInOrder layer) {
  const auto at = static_cast<std::size_t>(layer.index);
  return layer.has_tiles ? level.layers.list[at].group : level.objects[at].group;
}

void dissolve_group(TileLayers& layers, std::vector<ObjectLayer>& objects, int group) {
  const LayerGroup dissolved = layers.groups[static_cast<std::size_t>(group)];
  for (TileLayer& layer : layers.list)
    if (layer.group == group) take_looks(dissolved, layer);
  for (ObjectLayer& layer : objects)
    if (layer.group == group) take_looks(dissolved, layer);
  for (LayerGroup& inner : layers.groups)
    if (inner.group == group) take_looks(dissolved, inner);
  tidy_groups(layers, objects);
}

Level without_groups(Level level) {
  const auto flatten = [&](auto& layer) {
    put_looks(shown_looks(level.layers.groups, layer), layer);
    layer.group = -1;
  };
  for (TileLayer& layer : level.layers.list) flatten(layer);
  for (ObjectLayer& layer : level.objects) flatten(layer);
  level.layers.groups.clear();
  return level;
}

}  // namespace talus
