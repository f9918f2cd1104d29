// Which items of a changed list are those of the old one.
#pragma once

#include <functional>
#include <vector>

namespace talus {

inline constexpr int kSameItem = 1000;

// How much an old item and a new one have in common: kSameItem if they are equal, less if one may have become
// the other, 0 if not.
using ItemLikeness = std::function<int(int before, int now)>;

// By new item, the index of the old one; -1: it is new. The pairs keep the order of the lists, and have the
// most in common together, if the changed parts are not too long to try all.
std::vector<int> pair_items(int before, int now, const ItemLikeness& likeness);

}  // namespace talus
