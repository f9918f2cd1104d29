// Equal items at both ends are paired first, so that few are left to compare.
#include "tiled_pairs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace talus {
namespace {

constexpr std::size_t kMaxCompared = 1'000'000;  // pairs
constexpr int kReach = 64;                       // items, of the search in longer lists

struct ItemRange {
  int before, now, before_end, now_end;
};

// The alignment of two sequences with the greatest sum.
void align(const ItemRange& range, const ItemLikeness& likeness, std::vector<int>& pairs) {
  enum Step : std::uint8_t { skip_before, skip_now, pair };
  const auto rows = static_cast<std::size_t>(range.before_end - range.before);
  const auto columns = static_cast<std::size_t>(range.now_end - range.now);
  std::vector<Step> steps(rows * columns);
  std::vector<int> above(columns + 1), row(columns + 1);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < columns; ++k) {
      const int like = likeness(range.before + static_cast<int>(i), range.now + static_cast<int>(k));
      Step& step = steps[i * columns + k];
      step = above[k + 1] > row[k] ? skip_before : skip_now;
      row[k + 1] = std::max(above[k + 1], row[k]);
      if (like > 0 && above[k] + like > row[k + 1]) {
        step = pair;
        row[k + 1] = above[k] + like;
      }
    }
    std::swap(above, row);
    row[0] = 0;
  }
  for (std::size_t i = rows, k = columns; i > 0 && k > 0;) {
    const Step step = steps[(i - 1) * columns + (k - 1)];
    if (step == pair)
      pairs[static_cast<std::size_t>(range.now) + k - 1] = range.before + static_cast<int>(i) - 1;
    i -= step != skip_now ? 1 : 0;
    k -= step != skip_before ? 1 : 0;
  }
}

// Looks for each new item a little ahead.
void look_ahead(const ItemRange& range, const ItemLikeness& likeness, std::vector<int>& pairs) {
  int next = range.before;
  for (int now = range.now; now < range.now_end && next < range.before_end; ++now) {
    const int end = std::min(next + kReach, range.before_end);
    int found = next;
    while (found < end && likeness(found, now) != kSameItem) ++found;
    if (found == end && likeness(next, now) > 0) found = next;
    if (found == end) continue;
    pairs[static_cast<std::size_t>(now)] = found;
    next = found + 1;
  }
}

}  // namespace

std::vector<int> pair_items(int before, int now, const ItemLikeness& likeness) {
  std::vector<int> pairs(static_cast<std::size_t>(now), -1);
  ItemRange range{0, 0, before, now};
  const auto has_both = [&] { return range.before < range.before_end && range.now < range.now_end; };
  for (; has_both() && likeness(range.before, range.now) == kSameItem; ++range.before, ++range.now)
    pairs[static_cast<std::size_t>(range.now)] = range.before;
  for (; has_both() && likeness(range.before_end - 1, range.now_end - 1) == kSameItem;
       --range.before_end, --range.now_end)
    pairs[static_cast<std::size_t>(range.now_end) - 1] = range.before_end - 1;
  if (!has_both()) return pairs;
  const auto compared = static_cast<std::size_t>(range.before_end - range.before) *
                        static_cast<std::size_t>(range.now_end - range.now);
  if (compared <= kMaxCompared)
    align(range, likeness, pairs);
  else
    look_ahead(range, likeness, pairs);
  return pairs;
}

}  // namespace talus
