#include "step_limits.h"

#include <algorithm>

namespace talus {

StepBudget::StepBudget(std::size_t bodies) {
  const auto equal = kMaxStepWork / std::max<std::int64_t>(static_cast<std::int64_t>(bodies), 1);
  most_of_body_ = std::clamp(2 * equal, kLeastBodyWork, kMaxBodyWork);
}

std::int64_t StepBudget::part() const {
  return std::clamp<std::int64_t>(kMaxStepWork - spent_, 0, most_of_body_);
}

Vec2 within_limits(Vec2 from, Vec2 goal) {
  const auto limit = [](double at, double to) {
    const double reachable = std::clamp(to, at - kMaxBodySpeed, at + kMaxBodySpeed);
    return std::clamp(reachable, -kMaxBodyDistance, kMaxBodyDistance);
  };
  return {limit(from.x, goal.x), limit(from.y, goal.y)};
}

}  // namespace talus
