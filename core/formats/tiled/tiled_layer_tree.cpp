#include "tiled_layer_tree.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "../../level/layer_tree.h"

namespace talus {
namespace {

using Kind = TiledLayerKind;
using Key = std::pair<Kind, int>;  // of a layer or a group of the map, its kind and its number

TiledLayerNode* find_node(TiledLayerTree& tree, Key key) {
  for (TiledLayerNode& node : tree) {
    if (node.kind == key.first && node.from == key.second) return &node;
    if (TiledLayerNode* const found = find_node(node.inside, key)) return found;
  }
  return nullptr;
}

bool is_same(const TiledLayerTree& a, const TiledLayerTree& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TiledLayerNode& x, const auto& y) {
    return x.kind == y.kind && x.from == y.from && is_same(x.inside, y.inside);
  });
}

void note_tiles(const TiledLayerTree& tree, std::vector<int>& numbers) {
  for (const TiledLayerNode& node : tree) {
    if (node.kind == Kind::tiles && node.from >= 0) numbers.push_back(node.from);
    note_tiles(node.inside, numbers);
  }
}

class Arranger {
 public:
  Arranger(const Level& level, const TiledLayerTree& map, const TiledLayerSources& sources)
      : level_(level), map_(map), sources_(sources) {
    for (std::size_t k = 0; k < sources.objects.layers.size(); ++k)
      is_shown_.insert(sources.objects.layers[k]);
    note_groups(map, {});
  }

  TiledArrangement run() {
    pair_groups();
    std::size_t next = 0;
    nodes_ = layer_tree(level_, false);
    made_.tree = wanted(next, 0);
    keep_unseen(map_, {Kind::groups, -1});
    add_new();
    made_.objects.assign(sources_.objects.order.size(), -1);
    made_.groups.assign(level_.layers.groups.size(), -1);
    number(made_.tree);
    made_.is_new = !is_same(made_.tree, map_);
    return std::move(made_);
  }

 private:
  // Notes in which groups of the map its layers are, and what the groups are called.
  void note_groups(const TiledLayerTree& tree, const std::vector<int>& around) {
    for (const TiledLayerNode& node : tree) {
      if (node.kind != Kind::groups) {
        groups_of_[{node.kind, node.from}] = around;
        if (is_opened(node)) seen_.insert(around.begin(), around.end());
        continue;
      }
      names_[node.from] = node.name;
      std::vector<int> inside = around;
      inside.push_back(node.from);
      note_groups(node.inside, inside);
    }
  }
  bool is_opened(const TiledLayerNode& node) const {
    const std::vector<bool>& opened =
        node.kind == Kind::tiles ? sources_.opened_tiles : sources_.opened_objects;
    return static_cast<std::size_t>(node.from) < opened.size() && opened[static_cast<std::size_t>(node.from)];
  }

  // The layer of the map that a layer of the level is; with -1 if it is a new one or will not be in it.
  Key key_of(const LayerInOrder& layer) const {
    const auto at = static_cast<std::size_t>(layer.index);
    if (layer.has_tiles) return {Kind::tiles, at < sources_.tiles.size() ? sources_.tiles[at] : -1};
    const int slot = slot_of(layer);
    return {Kind::objects, slot < 0 ? -1 : sources_.objects.order[static_cast<std::size_t>(slot)].from};
  }
  int slot_of(const LayerInOrder& layer) const {
    const auto at = static_cast<std::size_t>(layer.index);
    return at < sources_.objects.layers.size() ? sources_.objects.layers[at] : -1;
  }

  void pair_groups() {
    constexpr int kSameName = 1 << 20, kSameDepth = 1 << 16;
    std::map<std::pair<int, int>, int> votes;  // by group of the level and of the map
    for (const LayerInOrder& layer : layers_in_order(level_)) {
      const auto there = groups_of_.find(key_of(layer));
      if (there == groups_of_.end()) continue;
      const std::vector<int> here = groups_around(level_.layers.groups, group_of(level_, layer));
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t k = 0; k < there->second.size(); ++k) {
          int& count = votes[{here[i], there->second[k]}];
          const std::string& name = level_.layers.groups[static_cast<std::size_t>(here[i])].name;
          if (count == 0)
            count = (name == names_[there->second[k]] ? kSameName : 0) + (i == k ? kSameDepth : 0);
          ++count;
        }
      }
    }
    std::vector<std::tuple<int, int, int>> best;  // the count less than 0, and the pair
    for (const auto& [pair, count] : votes) best.emplace_back(-count, pair.first, pair.second);
    std::sort(best.begin(), best.end());
    for (const auto& [count, here, there] : best) {
      if (group_pairs_.contains(here) || is_paired_.contains(there)) continue;
      group_pairs_[here] = there;
      is_paired_.insert(there);
    }
  }

  // The nodes of the level from `next` on that are at that depth.
  TiledLayerTree wanted(std::size_t& next, int depth) {
    TiledLayerTree tree;
    while (next < nodes_.size() && nodes_[next].depth == depth) {
      const LayerNode& node = nodes_[next++];
      if (node.is_group) {
        const auto pair = group_pairs_.find(node.group);
        TiledLayerNode group{Kind::groups, pair == group_pairs_.end() ? -1 : pair->second,
                             level_.layers.groups[static_cast<std::size_t>(node.group)].name, node.group};
        group.inside = wanted(next, depth + 1);
        if (!group.inside.empty()) tree.push_back(std::move(group));
        continue;
      }
      const Key key = key_of(node.layer);
      if (node.layer.has_tiles && !sources_.tiles.empty()) {
        const auto at = static_cast<std::size_t>(node.layer.index);
        const std::string& name = level_.layers.list[at].name;
        const bool is_nameless = name.empty() && sources_.opened_tiles.empty();
        tree.push_back(
            {Kind::tiles, key.second, is_nameless ? std::string(kTiledTileLayer) : name, node.layer.index});
      } else if (const int slot = slot_of(node.layer); !node.layer.has_tiles && slot >= 0) {
        tree.push_back(
            {Kind::objects, key.second, sources_.objects.order[static_cast<std::size_t>(slot)].name, slot});
      }
    }
    return tree;
  }

  // The place of a layer of objects of the map in their order, if the level does not show it; -1: it goes.
  int unseen_slot(const TiledLayerNode& node) const {
    const std::vector<TiledLayerSlot>& order = sources_.objects.order;
    for (std::size_t slot = 0; slot < order.size(); ++slot)
      if (order[slot].from == node.from && !is_shown_.contains(static_cast<int>(slot)))
        return static_cast<int>(slot);
    return -1;
  }

  bool is_unseen(const TiledLayerNode& layer) const {
    return layer.kind == Kind::tiles ? !is_opened(layer) : unseen_slot(layer) >= 0;
  }
  bool has_unseen(const TiledLayerTree& tree) const {
    return std::any_of(tree.begin(), tree.end(), [this](const TiledLayerNode& node) {
      return node.kind == Kind::groups ? has_unseen(node.inside) : is_unseen(node);
    });
  }

  // A group that the level has no more stays if it has such layers: their bodies are where its offset puts
  // them.
  // tree: a part of the map; parent: the group that it comes into, with the number -1 for the map.
  void keep_unseen(const TiledLayerTree& tree, Key parent) {
    std::vector<Key> behind;  // the layers and groups before the next one
    for (const TiledLayerNode& node : tree) {
      const Key key{node.kind, node.from};
      const bool is_group = node.kind == Kind::groups;
      if (find_node(made_.tree, key) == nullptr) {
        const int slot = node.kind == Kind::objects ? unseen_slot(node) : -1;
        if (is_group ? seen_.contains(node.from) && !has_unseen(node.inside) : !is_unseen(node)) continue;
        insert({node.kind, node.from, node.name, slot}, parent, behind);
      }
      if (is_group) keep_unseen(node.inside, key);
      behind.push_back(key);
    }
  }

  // Puts a node behind the last of those layers of tiles and groups that is in the parent, and behind the
  // layers of objects there that come before it.
  void insert(TiledLayerNode node, Key parent, const std::vector<Key>& behind) {
    TiledLayerNode* const group = parent.second < 0 ? nullptr : find_node(made_.tree, parent);
    TiledLayerTree& list = group == nullptr ? made_.tree : group->inside;
    auto place = list.begin();
    for (auto key = behind.rbegin(); key != behind.rend() && place == list.begin(); ++key) {
      if (key->first == Kind::objects) continue;
      const auto found = std::find_if(list.begin(), list.end(), [&](const TiledLayerNode& other) {
        return other.kind != Kind::objects && other.from >= 0 && Key(other.kind, other.from) == *key;
      });
      if (found != list.end()) place = found + 1;
    }
    const auto comes_before = [&](const TiledLayerNode& other) {
      if (other.kind != Kind::objects) return false;
      if (node.kind == Kind::objects) return other.slot < node.slot;
      return std::find(behind.begin(), behind.end(), Key(other.kind, other.from)) != behind.end();
    };
    while (place != list.end() && comes_before(*place)) ++place;
    list.insert(place, std::move(node));
  }

  // New layers of objects that the level does not show, such as that of bodies.
  void add_new() {
    const std::vector<TiledLayerSlot>& order = sources_.objects.order;
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
      if (order[slot].from < 0 && !is_shown_.contains(static_cast<int>(slot)))
        made_.tree.push_back({Kind::objects, -1, order[slot].name, static_cast<int>(slot)});
    }
  }

  void number(const TiledLayerTree& tree) {
    for (const TiledLayerNode& node : tree) {
      if (node.kind == Kind::objects) made_.objects[static_cast<std::size_t>(node.slot)] = objects_++;
      if (node.kind != Kind::groups) continue;
      if (node.slot >= 0) made_.groups[static_cast<std::size_t>(node.slot)] = groups_;
      ++groups_;
      number(node.inside);
    }
  }

  const Level& level_;
  const TiledLayerTree& map_;
  const TiledLayerSources& sources_;
  std::set<int> is_shown_;                     // places of layers of objects that the level has
  std::map<Key, std::vector<int>> groups_of_;  // by layer of the map, the groups that it is in
  std::map<int, std::string> names_;           // by group of the map
  std::set<int> seen_;                         // groups of the map that the opened level has
  std::map<int, int> group_pairs_;             // by group of the level, that of the map
  std::set<int> is_paired_;                    // groups of the map
  std::vector<LayerNode> nodes_;
  TiledArrangement made_;
  int objects_ = 0, groups_ = 0;  // that have a number
};

}  // namespace

TiledArrangement arrange_layers(const Level& level, const TiledLayerTree& map,
                                const TiledLayerSources& sources) {
  return Arranger(level, map, sources).run();
}

bool has_tiles_in_order(const TiledLayerTree& tree) {
  std::vector<int> numbers;
  note_tiles(tree, numbers);
  return std::is_sorted(numbers.begin(), numbers.end());
}

}  // namespace talus
