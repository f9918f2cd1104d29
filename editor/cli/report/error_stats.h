// The statistics of a row's errors.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace talus {

struct Spread {
  double max = 0;
  double p999 = 0;  // the 99.9th percentile
};

// Collects errors of one kind, in px.
class Errors {
 public:
  void add(double error) { values_.push_back(error); }
  std::size_t count() const { return values_.size(); }
  // Returns nothing without errors. NaN counts as infinite: it is a large error.
  std::optional<Spread> spread() const;

 private:
  std::vector<double> values_;
};

// The smallest value that at least this share (0..1) of the values do not exceed; `values` must not be empty.
double percentile(std::vector<double> values, double share);

struct Counts {
  std::size_t misses = 0;     // met something only according to the exact answer
  std::size_t ghosts = 0;     // met something only according to the solver
  std::size_t tunnels = 0;    // ended on the far side of what it should have met
  std::size_t teleports = 0;  // moved further than asked for
};

// Whether a body that should move by (x, y), px, and moved by (to_x, to_y) went further by more than
// kTeleport.
inline constexpr double kTeleport = 1;  // px, far more than rounding at the largest scale
bool is_teleport(double x, double y, double to_x, double to_y);

}  // namespace talus
