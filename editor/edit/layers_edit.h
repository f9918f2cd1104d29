// Edits that put layers of all kinds into another order, or into other groups.
#pragma once

#include <string>
#include <vector>

#include "level/edit.h"
#include "level/layer_tree.h"

namespace talus {

// The edit to these layers. In `after`, the layer that was chosen has no cells, if it is still there. Groups
// without layers go. It is empty if there were more groups than kMaxLayerGroups, or more than kMaxGroupDepth
// in one another.
Edit layers_edit(const Level& level, std::string label, TileLayers after, std::vector<ObjectLayer> others);

// A layer in the order that all get.
struct LayerEntry {
  LayerInOrder layer;    // of the level
  int group = -1;        // the group that it gets, an index in the list of them
  bool is_copy = false;  // whether it is another one with the same content
};
// All layers as they are, from the back to the front.
std::vector<LayerEntry> layer_entries(const Level& level);
// The edit to this order, and to these groups. entries: at least one is of tiles. The chosen layer stays the
// chosen one, or the one behind it becomes so.
Edit layers_edit(const Level& level, std::string label, const std::vector<LayerEntry>& entries,
                 LayerGroups groups);

// Returns the value within least..most, or within -most..most for both parts; what is not a number stays as
// before.
double in_range(double value, double least, double most, double before);
Vec2 in_range(Vec2 value, double most, Vec2 before);
// Brings the opacity, offset and parallax that a layer or a group gets into their ranges.
template <class Looks>
void keep_in_range(Looks& looks, const Looks& before) {
  looks.opacity = in_range(looks.opacity, 0, 1, before.opacity);
  looks.offset = in_range(looks.offset, kMaxLayerOffset, before.offset);
  looks.parallax = in_range(looks.parallax, kMaxParallax, before.parallax);
}

// The layer of tiles with its own cells.
TileLayer copy_of_layer(const Level& level, int layer);

}  // namespace talus
