// What the file of the open level cannot hold, found when an edit would make it.
#pragma once

#include <vector>

#include "formats/tiled/tiled_limits.h"
#include "level/edit.h"

namespace talus {

// The limits of its map of Tiled that a level would be beyond after an edit; none if the map holds all of it,
// or if the level did not come from one.
std::vector<BeyondTiled> beyond_tiled_after(const Level& level, const Edit& edit);

}  // namespace talus
