// The groups of layers of three levels that are merged.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "merge.h"

namespace talus {

// A group, as each of base, mine and theirs has it; nothing: that one lacks it. Its group is the number of
// another one in the list of all, or -1.
using GroupVersions = std::array<std::optional<LayerGroup>, 3>;

// Gives layers of the three levels the numbers of groups in the list that is returned, and takes the groups
// away. A group is the same in two levels if it has the same name in the same group, or the same layers.
std::vector<GroupVersions> take_shared_groups(const std::array<Level*, 3>& levels);

// What only one side changed since `base`, or else what the side has, which counts as a conflict.
template <class T>
const T& pick_side(const T& base, const T& mine, const T& theirs, MergeSide side, int& conflicts) {
  if (mine == theirs || theirs == base) return mine;
  if (mine == base) return theirs;
  ++conflicts;
  return side == MergeSide::mine ? mine : theirs;
}

// The groups with what each side changed. Some may be in later ones, or in a ring, see tidy_groups().
LayerGroups merged_groups(const std::vector<GroupVersions>& groups, MergeSide side, int& conflicts);

}  // namespace talus
