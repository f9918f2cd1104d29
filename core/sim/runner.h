// Runner: a state on its way along a branch, with the scene and the solver that take it on.
#pragma once

#include <limits>
#include <list>
#include <memory>
#include <optional>

#include <talus/sim/solver.h>
#include "branch.h"

namespace talus {

// The state that goes on when the level becomes another version: bodies keep to their spawns, and
// carry_over() does the rest; at frame 0 it is the initial state. scene: of `after`.
State edited_state(State state, const LevelVersion& before, const LevelVersion& after, const Scene& scene);

class Runner {
 public:
  static constexpr std::int64_t kAllSteps = std::numeric_limits<std::int64_t>::max();

  explicit Runner(SceneCache& scenes) : scenes_(scenes) {}

  // Goes to a frame that the branch has been run to, by as few steps as it takes from where it is or from a
  // keyframe, and by no more than `most_steps`, 1 or more (asserted). False: it is on the way there, and the
  // next call goes on. record: if not null, of the step that led to where it is then; empty at frame 0.
  bool go_to(const Branch& branch, std::int64_t frame, StepRecord* record = nullptr,
             std::int64_t most_steps = kAllSteps);
  // The steps from where it is to that frame, if it can go there without starting from a keyframe; nothing:
  // it cannot.
  std::optional<std::int64_t> steps_to(const Branch& branch, std::int64_t frame) const;
  // From where it is on this branch to its next frame, with the recorded input and the edits of that frame.
  void step(const Branch& branch, StepRecord* record = nullptr);

  // Goes on from where it is by itself; the caller appends to the branch what it did.
  void step_by(const Input& input, StepRecord* record);
  bool edit(const VersionPtr& version);  // whether the bodies are still the same ones

  // That branch has what this one has up to the frame where the runner is.
  void change_branch(int branch) { branch_ = branch; }
  // Where it is is no longer part of any branch.
  void forget() { branch_ = 0; }

  const State& state() const { return state_; }
  const ScenePtr& scene() const { return scene_; }
  std::int64_t steps_again() const { return steps_again_; }  // made by go_to() and step() so far

 private:
  void use(const VersionPtr& version);
  void start(const Branch& branch, std::int64_t frame);

  SceneCache& scenes_;
  int branch_ = 0;  // that the state is a frame of; 0: of none
  State state_;
  VersionPtr version_;
  ScenePtr scene_;                  // of version_
  std::shared_ptr<Solver> solver_;  // null until a step needs it: painting while paused must not pay for it
  std::int64_t steps_again_ = 0;
};

// Several of them, so that whoever goes along one place of a run does not send back who is at another.
class Runners {
 public:
  explicit Runners(SceneCache& scenes) : scenes_(scenes) {}

  // The nearest before that frame; where there is none, the one used longest ago. Good until the next call.
  Runner& nearest(const Branch& branch, std::int64_t frame);
  void forget();                     // as each of them
  std::int64_t steps_again() const;  // of those that there are

 private:
  static constexpr std::size_t kMost = 4;

  SceneCache& scenes_;
  std::list<Runner> runners_;  // the one used last is first
};

}  // namespace talus
