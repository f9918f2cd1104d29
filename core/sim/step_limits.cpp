#include "step_limits.h"

#include <algorithm>

namespace talus {

std::int64_t max_work_per_body(std::size_t bodies) {
  const auto share = kMostStepWork / std::max<std::int64_t>(static_cast<std::int64_t>(bodies), 1);
  return std::clamp(share, kLeastBodyWork, kMostBodyWork);
}

Vec2 within_limits(Vec2 from, Vec2 goal) {
  const auto limit = [](double at, double to) {
    const double reachable = std::clamp(to, at - kMaxBodySpeed, at + kMaxBodySpeed);
    return std::clamp(reachable, -kMaxBodyDistance, kMaxBodyDistance);
  };
  return {limit(from.x, goal.x), limit(from.y, goal.y)};
}

}  // namespace talus
