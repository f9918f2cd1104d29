// How the layers of a map, whatever is in them, and groups of them are drawn by themselves.
#pragma once

#include <string>

#include <talus/level/placed_picture.h>
#include "level/edit.h"

namespace talus {

// Whether the level has such a layer.
bool has_layer(const Level& level, const LayerInOrder& layer);
// Its own looks, without those of its groups; LayerLooks() if there is no such layer.
LayerLooks looks_of(const Level& level, const LayerInOrder& layer);
// Gives it another opacity, offset, parallax and tint. Numbers are brought within their ranges; what is not a
// number stays as it is. Empty if there is no such layer, or if nothing changes.
Edit set_looks(const Level& level, const LayerInOrder& layer, const LayerLooks& looks);
// The same of a group, an index in TileLayers::groups.
LayerLooks looks_of_group(const Level& level, int group);
Edit set_looks_of_group(const Level& level, int group, const LayerLooks& looks);
// The name of a layer for people: "walls, 12 objects".
std::string layer_text(const Level& level, const LayerInOrder& layer);

}  // namespace talus
