// Goes along a branch.
#include "runner.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "../level/followed_spawn.h"

namespace talus {
namespace {

// A body belongs to its spawn, wherever that is in the list now. A body whose spawn is gone is taken away.
void follow_spawns(State& state, const std::vector<Spawn>& before, const std::vector<Spawn>& after) {
  if (before == after) return;
  std::erase_if(state.bodies, [&](Body& body) {
    if (body.origin.spawn < 0) return false;
    const auto now = followed_spawn(before, after, body.origin.spawn);
    body.origin.spawn = now.value_or(-1);
    return !now;
  });
}

}  // namespace

State edited_state(State state, const LevelVersion& before, const LevelVersion& after, const Scene& scene) {
  if (state.frame == 0) return initial_state(scene);
  follow_spawns(state, *before.spawns, *after.spawns);
  return carry_over(state, scene);
}

void Runner::use(const VersionPtr& version, const LoneBodyPtr& alone) {
  if (version == version_ && alone == alone_) return;
  version_ = version;
  alone_ = alone;
  scene_ = scenes_.scene_of(version, alone);
  solver_.reset();
}

std::optional<std::int64_t> Runner::steps_to(const Branch& branch, std::int64_t frame) const {
  const Keyframe* keyframe = branch.keyframes.before(frame);
  const std::int64_t begin = keyframe != nullptr ? keyframe->frame : 0;
  if (branch_ != branch.id || state_.frame > frame || state_.frame < begin) return std::nullopt;
  return frame - state_.frame;
}

void Runner::start(const Branch& branch, std::int64_t frame) {
  if (steps_to(branch, frame)) return;
  const Keyframe* keyframe = branch.keyframes.before(frame);
  const std::int64_t begin = keyframe != nullptr ? keyframe->frame : 0;
  branch_ = branch.id;
  use(branch.chapters[branch.chapter_at(begin)].version, branch.alone);
  if (keyframe != nullptr) {
    state_ = *keyframe->state;
  } else {
    state_ = start_state(*scene_, alone_.get());
  }
}

bool Runner::go_to(const Branch& branch, std::int64_t frame, StepRecord* record, std::int64_t most_steps) {
  assert(frame >= 0 && frame <= branch.run_frame() && most_steps >= 1);
  if (record != nullptr) record->clear();
  const bool steps_there = record != nullptr && frame > 0;
  start(branch, steps_there ? frame - 1 : frame);
  const std::int64_t end = state_.frame + std::min(frame - state_.frame, most_steps);
  while (state_.frame < end) step(branch, state_.frame + 1 == end ? record : nullptr);
  return end == frame;
}

void Runner::step(const Branch& branch, StepRecord* record) {
  assert(branch_ == branch.id && state_.frame < branch.last_frame());
  const auto& chapters = branch.chapters;
  std::size_t next = branch.chapter_at(state_.frame) + 1;
  step_by(branch.input(state_.frame + 1), record);
  ++steps_again_;
  for (; next < chapters.size() && chapters[next].first == state_.frame; ++next) edit(chapters[next].version);
}

void Runner::step_by(const Input& input, StepRecord* record) {
  if (solver_ == nullptr) solver_ = scenes_.solver_of(version_, scene_);
  solver_->step(state_, input, record);
}

bool Runner::edit(const VersionPtr& version) {
  const VersionPtr before = version_;
  use(version, alone_);
  State next =
      alone_ != nullptr ? carry_over(state_, *scene_) : edited_state(state_, *before, *version, *scene_);
  const bool same_bodies =
      std::equal(state_.bodies.begin(), state_.bodies.end(), next.bodies.begin(), next.bodies.end(),
                 [](const Body& a, const Body& b) { return a.id == b.id; });
  state_ = std::move(next);
  return same_bodies;
}

Runner& Runners::nearest(const Branch& branch, std::int64_t frame) {
  auto best = runners_.end();
  std::int64_t fewest = Runner::kAllSteps;
  for (auto each = runners_.begin(); each != runners_.end(); ++each) {
    const auto steps = each->steps_to(branch, frame);
    if (!steps || *steps >= fewest) continue;
    best = each;
    fewest = *steps;
  }
  if (best == runners_.end() && runners_.size() < kMax) best = runners_.emplace(best, scenes_);
  if (best == runners_.end()) --best;
  runners_.splice(runners_.begin(), runners_, best);
  return runners_.front();
}

void Runners::forget() {
  for (Runner& each : runners_) each.forget();
}

std::int64_t Runners::steps_again() const {
  std::int64_t steps = 0;
  for (const Runner& each : runners_) steps += each.steps_again();
  return steps;
}

}  // namespace talus
