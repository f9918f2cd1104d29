// Places of bodies that are free of the ground.
#pragma once

#include <optional>

#include <talus/level/level.h>

namespace talus {

// Whether the body starts in the ground of tiles: also one on its centre that has a corner there, and no
// slope under its middle.
bool starts_in_ground(const Level& level, const Spawn& spawn);

// Returns the nearest place (px, of the top left corner) straight above that is free of the ground, as
// free_above() does; if there is none on the map, the end of the shortest way out of the ground that stays on
// the map; otherwise the nearest free corner of a cell. Nothing: the ground around is full.
std::optional<Vec2> free_place(const Level& level, const Spawn& spawn);

}  // namespace talus
