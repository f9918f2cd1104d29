// Solver: takes a state one frame further.
#pragma once

#include <memory>

#include "record.h"
#include "state.h"

namespace talus {

// Tuning that adds energy would carry a body away for ever; these limits keep every number finite. A step
// that reaches one says so in its record.
inline constexpr double kMaxBodySpeed = 4096;    // px/frame in x and y: 512 tiles
inline constexpr double kMaxBodyDistance = 1e9;  // px from the origin in x and y

// What all bodies together, and one alone, may look at in a step: cells, lines and boxes, in units of some
// ns. So no step takes long, whatever the level; ordinary ones come nowhere near. A body that has used up its
// part stops at a place that it can be at, and the record says so.
inline constexpr std::int64_t kMostStepWork = 1 << 24;
inline constexpr std::int64_t kMostBodyWork = 1 << 20;
inline constexpr std::int64_t kLeastBodyWork = 1 << 10;
std::int64_t max_work_per_body(std::size_t bodies);

// A goal within these limits. What is within them is left as it is, to the last bit.
Vec2 within_limits(Vec2 from, Vec2 goal);

// Where a body that the mouse holds wants its top-left corner: part of the way to the mouse.
Vec2 drag_goal(const SharedTuning& tuning, const Body& body, const Input& input);

// A solver keeps working storage between steps, for speed alone: what step() does depends on nothing but the
// scene and its arguments, so one solver may step unrelated states in any order.
class Solver {
 public:
  virtual ~Solver() = default;
  // Advances `state` by one frame. `record`, when given, is overwritten with what happened.
  virtual void step(State& state, const Input& input, StepRecord* record = nullptr) = 0;
};

// The solver that the scene's tuning names.
std::unique_ptr<Solver> make_solver(std::shared_ptr<const Scene> scene);

// The same as one pure function, for callers that step once.
State step(const Scene& scene, const State& state, const Input& input, StepRecord* record = nullptr);

}  // namespace talus
