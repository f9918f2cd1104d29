// Finds spawns again after the list of spawns was edited.
#pragma once

#include <optional>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// Returns the new index of a spawn after spawns were added, removed or changed in one place of the list;
// nothing if it is gone. An index beyond the list stays.
std::optional<int> followed_spawn(const std::vector<Spawn>& before, const std::vector<Spawn>& after,
                                  int index);

}  // namespace talus
