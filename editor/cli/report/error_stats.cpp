#include "error_stats.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace talus {

std::optional<Spread> Errors::spread() const {
  if (values_.empty()) return std::nullopt;
  std::vector<double> values = values_;
  for (double& value : values) {
    if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  }
  return Spread{*std::max_element(values.begin(), values.end()), percentile(values, 0.999)};
}

double percentile(std::vector<double> values, double share) {
  assert(!values.empty() && share >= 0 && share <= 1);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

bool is_teleport(double x, double y, double to_x, double to_y) {
  return std::hypot(to_x, to_y) > std::hypot(x, y) + kTeleport;
}

}  // namespace talus
