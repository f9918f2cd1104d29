// The groups of layers: making, moving, copying, dissolving them, and how they look.
#pragma once

#include <optional>
#include <string>

#include "layers_edit.h"

namespace talus {

// group, here and below: an index in TileLayers::groups. Each edit is empty if there is no such group, or if
// it changes nothing.

// The place of a group among all layers; nothing if there is no such one.
std::optional<LayerNode> node_of_group(const Level& level, int group);
// The same of a layer of tiles, which must be there (asserted).
LayerNode node_of_layer(const Level& level, int layer);

// Puts a layer or a group into a new group, which stands where it stood.
Edit add_group(const Level& level, const LayerNode& node);
// Takes the group away: what was in it looks as before.
Edit ungroup(const Level& level, int group);
// Gives it everything of `looks` but the group that it is in. Opacity, offset and parallax are brought within
// their ranges; what is not a number stays as it is. The label says what changes: "Hide group".
Edit set_group_looks(const Level& level, int group, LayerGroup looks);
// Puts a copy with copies of all its layers in front of it.
Edit duplicate_group(const Level& level, int group);
// Removes it with its layers. Empty if no layer of tiles would be left.
Edit remove_group(const Level& level, int group);
// Moves a layer or a group in front of so many layers of layers_in_order(), and into a group; -1: into none.
// Empty if that group is the moved one, or in it.
Edit move_node(const Level& level, const LayerNode& node, int to, int group);
// Moves it forwards or backwards by one step: past the next layer, into the next group, or out of its own.
Edit step_node(const Level& level, const LayerNode& node, bool forwards);

// The name of a group for people: its own, or "Group 2" by its number.
std::string group_name(const Level& level, int group);
// Whether a group has a tile other than 0, an object or a picture.
bool has_content(const Level& level, int group);

}  // namespace talus
