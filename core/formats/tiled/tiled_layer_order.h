// How layers come into another order with few moves.
#pragma once

#include <vector>

namespace talus {

// By layer in the order that is wanted, whether it may stay where it is: the most that stand in that order
// already. places: where each of them is; -1: elsewhere.
std::vector<bool> layers_that_stay(const std::vector<int>& places);

}  // namespace talus
