// StepTimes: how long the steps took when they were made last, ns: by frame, for a plot. Results do not
// depend on it.
#pragma once

#include <limits>
#include <optional>

#include "debug/plot_series.h"

namespace talus {

class StepTimes {
 public:
  // Of the step to this frame, from 1.
  void note(std::int64_t frame, double ns) {
    if (!series_ || frame < series_->frames()) series_.emplace(0, kMaxPoints);
    while (series_->frames() < frame) series_->add(std::numeric_limits<double>::quiet_NaN());
    series_->add(ns);
  }
  void clear() { series_.reset(); }
  const Series* series() const { return series_ ? &*series_ : nullptr; }  // null: no step was made

 private:
  static constexpr std::size_t kMaxPoints = 1024;
  std::optional<Series> series_;
};

}  // namespace talus
