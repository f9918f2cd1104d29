// How far and how long one step of a solver may go.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/sim/solver.h>

namespace talus {

// What all bodies together may look at in a step: cells, lines and boxes, in units of about 20 ns. So no step
// takes long, whatever the level; ordinary ones come nowhere near. A body that has used up its part stops at
// a place that it can be at, and the record says so.
inline constexpr std::int64_t kMostStepWork = 3 << 21;
// One body's part: twice an equal one, as most need far less, but within these.
inline constexpr std::int64_t kMostBodyWork = 1 << 20;
inline constexpr std::int64_t kLeastBodyWork = 1 << 10;

// What is left of a step's work.
class StepBudget {
 public:
  StepBudget() = default;
  explicit StepBudget(std::size_t bodies);

  // What one body may look at now; 0: nothing any more.
  std::int64_t part() const;
  // What was looked at; the last one may have looked at more than was left.
  void spend(std::int64_t work) { spent_ += work; }
  std::int64_t spent() const { return spent_; }

 private:
  std::int64_t most_of_body_ = kMostBodyWork;
  std::int64_t spent_ = 0;
};

// A goal within these limits. What is within them is left as it is, to the last bit.
Vec2 within_limits(Vec2 from, Vec2 goal);

}  // namespace talus
