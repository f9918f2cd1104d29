// Edits of the groups.
#include "group_tools.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "level/single_change.h"

namespace talus {
namespace {

bool has_group(const Level& level, int group) {
  return group >= 0 && group < static_cast<int>(level.layers.groups.size());
}

LayerGroup& group_at(LayerGroups& groups, int group) { return groups[static_cast<std::size_t>(group)]; }

std::string free_group_name(const LayerGroups& groups) {
  for (std::size_t number = groups.size() + 1;; ++number) {
    std::string name = "Group " + std::to_string(number);
    const bool is_taken = std::any_of(groups.begin(), groups.end(),
                                      [&](const LayerGroup& group) { return group.name == name; });
    if (!is_taken) return name;
  }
}

bool is_in_group(const LayerGroups& groups, int inner, int group) {
  const std::vector<int> around = groups_around(groups, inner);
  return std::find(around.begin(), around.end(), group) != around.end();
}

int group_around(const Level& level, const LayerNode& node) {
  return node.is_group ? level.layers.groups[static_cast<std::size_t>(node.group)].group : node.group;
}

std::string label_of(const LayerGroup& before, const LayerGroup& after) {
  if (before.name != after.name) return "Rename group";
  if (before.visible != after.visible) return after.visible ? "Show group" : "Hide group";
  if (before.locked != after.locked) return after.locked ? "Lock group" : "Unlock group";
  if (before.opacity != after.opacity) return "Change a group's opacity";
  if (before.offset != after.offset) return "Change a group's offset";
  if (before.parallax != after.parallax) return "Change a group's parallax";
  return "Change a group's tint";
}

// Puts copies of a group and of those in it behind the others. Returns by group its copy, or itself.
std::vector<int> copy_groups(LayerGroups& groups, int group) {
  std::vector<int> copies(groups.size());
  const int count = static_cast<int>(groups.size());
  for (int i = 0; i < count; ++i) {
    copies[static_cast<std::size_t>(i)] = i;
    if (!is_in_group(groups, i, group)) continue;
    copies[static_cast<std::size_t>(i)] = static_cast<int>(groups.size());
    LayerGroup copy = group_at(groups, i);
    if (i == group)
      copy.name += " copy";
    else
      copy.group = copies[static_cast<std::size_t>(copy.group)];
    groups.push_back(std::move(copy));
  }
  return copies;
}

}  // namespace

std::optional<LayerNode> node_of_group(const Level& level, int group) {
  for (const LayerNode& node : layer_tree(level, false))
    if (node.is_group && node.group == group) return node;
  return std::nullopt;
}

LayerNode node_of_layer(const Level& level, int layer) {
  for (const LayerNode& node : layer_tree(level, false))
    if (!node.is_group && node.layer == LayerInOrder{true, layer}) return node;
  assert(false);
  return {};
}

Edit add_group(const Level& level, const LayerNode& node) {
  LayerGroups groups = level.layers.groups;
  std::vector<LayerEntry> entries = layer_entries(level);
  const int added = static_cast<int>(groups.size());
  const int around = group_around(level, node);
  groups.push_back({.name = free_group_name(groups), .group = around});
  if (node.is_group)
    group_at(groups, node.group).group = added;
  else
    entries[static_cast<std::size_t>(node.begin)].group = added;
  return layers_edit(level, "Group layers", entries, std::move(groups));
}

Edit ungroup(const Level& level, int group) {
  const std::string label = "Ungroup layers";
  if (!has_group(level, group)) return {label, {}};
  TileLayers after = level.layers;
  std::vector<ObjectLayer> others = level.objects;
  dissolve_group(after, others, group);
  return layers_edit(level, label, std::move(after), std::move(others));
}

Edit set_group_looks(const Level& level, int group, LayerGroup looks) {
  if (!has_group(level, group)) return {"Change group", {}};
  TileLayers after = level.layers;
  LayerGroup& its = group_at(after.groups, group);
  looks.group = its.group;
  keep_in_range(looks, its);
  std::string label = label_of(its, looks);
  its = std::move(looks);
  Edit edit = single_change(std::move(label), LayersChange{level.layers, std::move(after)});
  edit.layer = level.layers.chosen;
  return edit;
}

Edit duplicate_group(const Level& level, int group) {
  const std::string label = "Duplicate group";
  const auto node = node_of_group(level, group);
  if (!node) return {label, {}};
  LayerGroups groups = level.layers.groups;
  const std::vector<int> copy_of = copy_groups(groups, group);
  std::vector<LayerEntry> entries = layer_entries(level);
  std::vector<LayerEntry> copies(entries.begin() + node->begin, entries.begin() + node->end);
  for (LayerEntry& copy : copies) copy = {copy.layer, copy_of[static_cast<std::size_t>(copy.group)], true};
  entries.insert(entries.begin() + node->end, copies.begin(), copies.end());
  return layers_edit(level, label, entries, std::move(groups));
}

Edit remove_group(const Level& level, int group) {
  const std::string label = "Delete group";
  std::vector<LayerEntry> entries = layer_entries(level);
  std::erase_if(
      entries, [&](const LayerEntry& entry) { return is_in_group(level.layers.groups, entry.group, group); });
  const bool has_tiles = std::any_of(entries.begin(), entries.end(),
                                     [](const LayerEntry& entry) { return entry.layer.has_tiles; });
  if (!has_group(level, group) || !has_tiles) return {label, {}};
  return layers_edit(level, label, entries, level.layers.groups);
}

Edit move_node(const Level& level, const LayerNode& node, int to, int group) {
  const std::string label = node.is_group ? "Move group" : "Move layer";
  if (node.is_group && is_in_group(level.layers.groups, group, node.group)) return {label, {}};
  LayerGroups groups = level.layers.groups;
  std::vector<LayerEntry> entries = layer_entries(level);
  std::vector<LayerEntry> moved(entries.begin() + node.begin, entries.begin() + node.end);
  if (node.is_group)
    group_at(groups, node.group).group = group;
  else
    moved.front().group = group;
  entries.erase(entries.begin() + node.begin, entries.begin() + node.end);
  if (to >= node.end)
    to -= node.end - node.begin;
  else
    to = std::min(to, node.begin);
  to = std::clamp(to, 0, static_cast<int>(entries.size()));
  entries.insert(entries.begin() + to, moved.begin(), moved.end());
  return layers_edit(level, label, entries, std::move(groups));
}

Edit step_node(const Level& level, const LayerNode& node, bool forwards) {
  const int around = group_around(level, node), edge = forwards ? node.end : node.begin;
  for (const LayerNode& other : layer_tree(level, false)) {
    const bool is_around =
        other.is_group && other.group == around && other.begin <= node.begin && other.end >= node.end;
    if (is_around && (forwards ? other.end : other.begin) == edge)
      return move_node(level, node, node.begin, group_around(level, other));
    const bool is_next = group_around(level, other) == around &&
                         (forwards ? other.begin : other.end) == edge && other.end > other.begin;
    if (!is_next) continue;
    return other.is_group ? move_node(level, node, node.begin, other.group)
                          : move_node(level, node, forwards ? other.end : other.begin, around);
  }
  return {node.is_group ? "Move group" : "Move layer", {}};
}

std::string group_name(const Level& level, int group) {
  const std::string& name = level.layers.groups[static_cast<std::size_t>(group)].name;
  return name.empty() ? "Group " + std::to_string(group + 1) : name;
}

bool has_content(const Level& level, int group) {
  const auto is_in = [&](int its) { return is_in_group(level.layers.groups, its, group); };
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const std::vector<TileNumber>& tiles = level.cells_of(layer).tiles();
    const bool is_blank = std::all_of(tiles.begin(), tiles.end(), [](TileNumber tile) { return tile == 0; });
    if (is_in(level.layers.list[static_cast<std::size_t>(layer)].group) && !is_blank) return true;
  }
  return std::any_of(level.objects.begin(), level.objects.end(), [&](const ObjectLayer& layer) {
    return is_in(layer.group) && (layer.image || !layer.objects.empty());
  });
}

}  // namespace talus
