// Finds what Talus wrote by its x, which Tiled rounds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "tiled_objects.h"

namespace talus {

// x_of(entry): px. The entries must be sorted by it.
template <class Entry, class XOf>
std::span<const Entry> near_in_x(std::span<const Entry> by_x, double x, const XOf& x_of) {
  constexpr std::ptrdiff_t kMax = 512;      // in hostile maps these may be all of them
  const double slack = 2 * tiled_slack(x);  // that of the larger number
  const auto first = std::lower_bound(by_x.begin(), by_x.end(), x - slack,
                                      [&](const Entry& entry, double least) { return x_of(entry) < least; });
  const auto end = std::upper_bound(first, by_x.end(), x + slack,
                                    [&](double most, const Entry& entry) { return most < x_of(entry); });
  return {first, first + std::min(end - first, kMax)};
}

template <class Entry, class XOf>
void sort_by_x(std::vector<Entry>& entries, const XOf& x_of) {
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const Entry& a, const Entry& b) { return x_of(a) < x_of(b); });
}

}  // namespace talus
