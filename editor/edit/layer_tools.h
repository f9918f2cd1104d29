// The layers of a map: adding, ordering, merging, and how those of tiles look.
#pragma once

#include <optional>
#include <string>

#include "level/edit.h"

namespace talus {

// layer, here and below: an index in Level::layers, from the back. Each edit is empty if there is no such
// layer, or if it changes nothing. The level is one undo step before it, with the layer that was chosen.

// A new layer of tile 0 in front of the chosen one, in its group. It becomes the chosen one.
Edit add_layer(const Level& level);
// A copy in front of it, which becomes the chosen one.
Edit duplicate_layer(const Level& level, int layer);
// Removes it with its tiles. If it was chosen, the one behind it becomes so, or the last one. Empty for the
// only layer.
Edit remove_layer(const Level& level, int layer);
// Puts its tiles other than 0 over those of the layer behind it, which keeps its looks and becomes the chosen
// one. Empty for the layer at the back.
Edit merge_layer_down(const Level& level, int layer);
// Moves it to the index `to`, past the layers between. The chosen layer stays the chosen one.
Edit move_layer(const Level& level, int layer, int to);
// Puts all layers, those of objects and pictures too, into another order: that of layers_in_order(), with the
// element at index `from` moved to index `to`.
Edit move_in_order(const Level& level, int from, int to);
// Gives it everything of `looks` but its cells and its group. Opacity, offset and parallax are brought within
// their ranges; what is not a number stays as it is. The label says what changes: "Hide layer".
Edit set_layer_looks(const Level& level, int layer, TileLayer looks);

// The name of a layer for people: its own, or "Layer 2" by its place, 1 at the back.
std::string layer_name(const Level& level, int layer);
// Why the user may not paint what an edit paints: it changes tiles of the chosen layer, which is locked or
// hidden. A sentence; nothing if it may be painted.
std::optional<std::string> problem_of_painting(const Level& level, const Edit& edit);

}  // namespace talus
