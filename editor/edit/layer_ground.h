// Ground for maps that have none yet.
#pragma once

#include <optional>
#include <string>

#include "level/edit.h"

namespace talus {

// Whether the map shows tiles, and nothing of the level is ground: no tile, curve or object.
bool lacks_ground(const Level& level);

// What gives ground to a map of Tiled or LDtk that lacks it, an order without full stop. Nothing for others:
// tilesets, carts and levels of Talus may be without ground on purpose.
std::optional<std::string> ways_to_ground(const Level& level);

// Makes the tiles that the chosen layer shows full ground, apart from those with a shape or that stand for a
// body, and the layer a layer of ground. Other layers that show such a tile become scenery, unless they hold
// bodies. Empty if there is no such tile.
Edit make_tiles_ground(const Level& level);

}  // namespace talus
