// The bodies of `talus bench`.
#pragma once

#include <cstdint>

#include <talus/level/level.h>

namespace talus {

// Adds balls on cells where they overlap nothing, each cell once. Returns false if there are too few cells.
// The seed chooses the cells.
bool spawn_balls(Level& level, int count, std::uint64_t seed);

}  // namespace talus
