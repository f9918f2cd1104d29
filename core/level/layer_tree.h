// The layers of a level with their groups around them.
#pragma once

#include <vector>

#include <talus/level/placed_picture.h>

namespace talus {

// A layer or a group of them, as it stands among the others.
struct LayerNode {
  bool is_group = false;
  LayerInOrder layer = {};  // of a layer
  int group = -1;           // of a group, its index in TileLayers::groups; of a layer the one that it is in
  int depth = 0;            // the number of groups that it is in
  // The layers of it in layers_in_order(): from `begin` to the one before `end`.
  int begin = 0, end = 0;
  friend bool operator==(const LayerNode&, const LayerNode&) = default;
};
// All of them, each group before what is in it. A group whose layers do not stand together comes several
// times. front_first: from the front to the back; else from the back.
std::vector<LayerNode> layer_tree(const Level& level, bool front_first);

// The groups that a group is in, and itself, the outermost first; empty for -1.
std::vector<int> groups_around(const LayerGroups& groups, int group);
// The number of the group that a layer is in; -1: none.
int group_of(const Level& level, LayerInOrder layer);

// Takes a group out of all that is directly in it, so that it looks as before, in the group around.
void dissolve_group(TileLayers& layers, std::vector<ObjectLayer>& objects, int group);
// The level with layers that look the same without groups.
Level without_groups(Level level);

}  // namespace talus
