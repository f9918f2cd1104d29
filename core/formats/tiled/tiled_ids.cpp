#include "tiled_ids.h"

#include <algorithm>
#include <utility>

namespace talus {
namespace {

constexpr std::int64_t kMaxTiledId = 2'000'000'000;  // well within an int

}  // namespace

// Numbers that are too large are none that Talus gives.
TiledIds::TiledIds(std::vector<std::int64_t> used, std::int64_t next) : used_(std::move(used)) {
  std::sort(used_.begin(), used_.end());
  const std::int64_t last = used_.empty() ? 0 : std::min(used_.back(), kMaxTiledId);  // so that 1 more fits
  const std::int64_t behind = std::max<std::int64_t>({1, next, last + 1});
  if (behind <= kMaxTiledId) {
    next_ = static_cast<int>(behind);
    return;
  }
  for (const std::int64_t id : used_) {  // the first gap
    if (id > next_) break;
    if (id == next_) ++next_;
  }
}

int TiledIds::take() {
  has_taken_ = true;
  const int taken = next_++;
  while (std::binary_search(used_.begin(), used_.end(), std::int64_t{next_})) ++next_;
  return taken;
}

}  // namespace talus
