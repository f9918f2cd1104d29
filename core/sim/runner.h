// Runner: a state at a place of a branch, with the scene and the solver for the next step.
#pragma once

#include <limits>
#include <list>
#include <memory>
#include <optional>

#include <talus/sim/solver.h>
#include "branch.h"

namespace talus {

// The state to go on with when the level becomes another version. Bodies belong to their spawns, and
// carry_over() does the rest; at frame 0 it is the initial state. scene: of `after`.
State edited_state(State state, const LevelVersion& before, const LevelVersion& after, const Scene& scene);

class Runner {
 public:
  static constexpr std::int64_t kAllSteps = std::numeric_limits<std::int64_t>::max();

  explicit Runner(SceneCache& scenes) : scenes_(scenes) {}

  // Goes to a frame that the branch has been run to, in as few steps as possible, from the current place or
  // from a keyframe; in at most `most_steps` (1 or more, asserted). Returns false if it is still on the way:
  // the next call goes on. record: if not null, gets the record of the last step; empty at frame 0.
  bool go_to(const Branch& branch, std::int64_t frame, StepRecord* record = nullptr,
             std::int64_t most_steps = kAllSteps);
  // The number of steps from the current place to that frame; nothing if it must start from a keyframe.
  std::optional<std::int64_t> steps_to(const Branch& branch, std::int64_t frame) const;
  // Goes to the next frame of this branch, with the recorded input and the edits of that frame.
  void step(const Branch& branch, StepRecord* record = nullptr);

  // Steps on its own; the caller appends the step to the branch.
  void step_by(const Input& input, StepRecord* record);
  bool edit(const VersionPtr& version);  // whether the bodies are still the same

  // Says that this branch equals the runner's branch up to the runner's frame.
  void change_branch(int branch) { branch_ = branch; }
  // The current place no longer belongs to any branch.
  void forget() { branch_ = 0; }

  const State& state() const { return state_; }
  const ScenePtr& scene() const { return scene_; }
  std::int64_t steps_again() const { return steps_again_; }  // steps made by go_to() and step() so far

 private:
  void use(const VersionPtr& version, const LoneBodyPtr& alone);
  void start(const Branch& branch, std::int64_t frame);

  SceneCache& scenes_;
  int branch_ = 0;  // the branch of the current state; 0: no branch
  State state_;
  VersionPtr version_;
  LoneBodyPtr alone_;               // as Branch::alone
  ScenePtr scene_;                  // of both
  std::shared_ptr<Solver> solver_;  // null until a step needs it: painting while paused must not pay for it
  std::int64_t steps_again_ = 0;
};

// Several runners, so that two readers of different places do not send each other back.
class Runners {
 public:
  explicit Runners(SceneCache& scenes) : scenes_(scenes) {}

  // The nearest runner before that frame; if there is none, the one used longest ago. Valid until the next
  // call.
  Runner& nearest(const Branch& branch, std::int64_t frame);
  void forget();                     // forgets the places of all
  std::int64_t steps_again() const;  // sum over all runners

 private:
  static constexpr std::size_t kMax = 4;

  SceneCache& scenes_;
  std::list<Runner> runners_;  // the last used one is first
};

}  // namespace talus
