// Edits what tiles say beside their pictures, flags and shapes.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/function_ref.h>
#include "sprite_area.h"

namespace talus {

// Each edit is for all tiles of an area. It is empty if they are no tiles of the map, or if nothing changes.

// The probability that all tiles of an area have; nothing if they differ, or are no tiles of the map.
std::optional<double> common_probability(const Level& level, const SpriteArea& area);
// Gives it to all of them. probability: 0..kMaxProbability (asserted).
Edit set_probability(const Level& level, const SpriteArea& area, double probability);
// Gives them a class; empty: none.
Edit set_tile_class(const Level& level, const SpriteArea& area, const std::string& type);
// Changes the properties of each. change: takes and returns them as in TileNote.
Edit change_tile_properties(const Level& level, const SpriteArea& area,
                            FunctionRef<std::string(const std::string&)> change);

}  // namespace talus
