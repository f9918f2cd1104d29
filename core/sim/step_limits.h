// How far and how long one step of a solver may go.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/sim/solver.h>

namespace talus {

// The work that all bodies together may take in a step: cells, lines and boxes, in units of about 20 ns. So
// no step takes long, whatever the level is; ordinary steps come nowhere near. A body that has used up its
// part stops at a free place, and the record says so.
inline constexpr std::int64_t kMaxStepWork = 3 << 21;
// Limits for one body's part. The part is twice an equal share, as most bodies need far less.
inline constexpr std::int64_t kMaxBodyWork = 1 << 20;
inline constexpr std::int64_t kLeastBodyWork = 1 << 10;

// The rest of a step's work.
class StepBudget {
 public:
  StepBudget() = default;
  explicit StepBudget(std::size_t bodies);

  // The work that one body may take now; 0: none is left.
  std::int64_t part() const;
  // Takes work off; the last body may have taken more than was left.
  void spend(std::int64_t work) { spent_ += work; }
  std::int64_t spent() const { return spent_; }

 private:
  std::int64_t most_of_body_ = kMaxBodyWork;
  std::int64_t spent_ = 0;
};

// Returns the goal within these limits. A goal within them is returned as it is, to the last bit.
Vec2 within_limits(Vec2 from, Vec2 goal);

}  // namespace talus
