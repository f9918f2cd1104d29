// Measures the rows of the report.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "error_stats.h"
#include "setup.h"

namespace talus {

struct Effort {
  std::size_t moves = 2000;  // at most, of a row; and balls times frames
  int repeats = 9;           // timings, of which the median counts
};

// Columns that do not apply to a row are left out.
struct Row {
  Setup setup;
  std::size_t moves = 0;
  std::optional<double> ns;  // for a move, or for a ball and frame; the median
  // px. Geometry: one move against the exact answer for the stored inputs, the larger of the distance of the
  // first contact and of the height over the floor at the end; for a wall the distance at the end. Impact:
  // the time of impact times the length of the motion. Trajectory: the same integrator in long double, over
  // all frames. Model: closed-form physics, over all frames.
  std::optional<Spread> geometry, impact, trajectory, model;
  std::optional<Counts> counts;  // of single moves
};

Row measure(const Setup& setup, const Effort& effort);

}  // namespace talus
