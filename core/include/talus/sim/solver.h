// Solver: takes a state one frame further.
#pragma once

#include <memory>

#include <talus/sim/record.h>
#include <talus/sim/state.h>

namespace talus {

// Tuning that adds energy would carry a body away for ever; these limits keep every number finite. A step
// that reaches one says so in its record.
inline constexpr double kMaxBodySpeed = 4096;    // px/frame in x and y: 512 tiles
inline constexpr double kMaxBodyDistance = 1e9;  // px from the origin in x and y

// A solver keeps working storage between steps, only for speed: the result of step() depends only on the
// scene and its arguments, so one solver may step unrelated states in any order.
class Solver {
 public:
  virtual ~Solver() = default;
  // Advances `state`, one of the solver's scene, by one frame. `record` is overwritten with what happened;
  // null: nothing is recorded.
  virtual void step(State& state, const Input& input, StepRecord* record = nullptr) = 0;
};

// The solver that the scene's tuning names, never null. scene: not null.
std::unique_ptr<Solver> make_solver(std::shared_ptr<const Scene> scene);

// A step as one pure function, for callers that step once.
State step(const Scene& scene, const State& state, const Input& input, StepRecord* record = nullptr);

}  // namespace talus
