// Spawns that are equal at the beginning and at the end of both lists are the same.
#include "followed_spawn.h"

#include <algorithm>

namespace talus {

std::optional<int> followed_spawn(const std::vector<Spawn>& before, const std::vector<Spawn>& after,
                                  int index) {
  const auto size = static_cast<std::ptrdiff_t>(before.size());
  const auto grown = static_cast<std::ptrdiff_t>(after.size()) - size;
  const auto first =
      std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin();
  const auto same_at_end =
      std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend()).first - before.rbegin();
  const auto last = std::min(same_at_end, std::min(size, size + grown) - first);  // equal ones count once
  if (index < first || index >= size || grown == 0) return index;
  if (index >= size - last) return static_cast<int>(index + grown);
  return {};
}

}  // namespace talus
