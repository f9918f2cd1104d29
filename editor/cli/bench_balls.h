// The bodies of `talus bench`.
#pragma once

#include <cstdint>

#include <talus/level/level.h>

namespace talus {

// Adds balls on cells where they overlap nothing, each cell once; false when there are too few. The seed says
// on which.
bool spawn_balls(Level& level, int count, std::uint64_t seed);

}  // namespace talus
