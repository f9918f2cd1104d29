// Small levels that are played and keep every frame, for the tests of the debugger.
#pragma once

#include <functional>
#include <vector>

#include <talus/sim/solver.h>
#include "debug/frame.h"

namespace talus {

class RecordedFrames final : public FrameSource {
 public:
  using InputAt = std::function<Input(std::int64_t frame)>;

  RecordedFrames(const Level& level, std::int64_t frames, const InputAt& input_at = {})
      : scene_(std::make_shared<const Scene>(compile_scene(level))),
        ground_(measured_ground(*scene_, level)) {
    frames_.push_back({scene_, ground_, initial_state(*scene_), {}, {}, {}});
    const auto solver = make_solver(scene_);
    while (last() < frames) {
      Frame next{scene_, ground_, frames_.back().state, {}, {}, {}};
      if (input_at) next.input = input_at(last() + 1);
      solver->step(next.state, next.input, &next.record);
      frames_.push_back(std::move(next));
    }
  }

  std::int64_t last() const override { return static_cast<std::int64_t>(frames_.size()) - 1; }
  void read(std::int64_t frame, Frame& into) const override {
    ++reads;
    into = at(frame);
  }
  const Frame& at(std::int64_t frame) const { return frames_[static_cast<std::size_t>(frame)]; }

  mutable std::int64_t reads = 0;  // frames read so far

 private:
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Terrain> ground_;
  std::vector<Frame> frames_;
};

// Handmade frames of the exact solver: these states, and empty records.
class MadeFrames final : public FrameSource {
 public:
  explicit MadeFrames(std::vector<State> states) : scene_(std::make_shared<const Scene>()) {
    for (State& state : states) {
      state.frame = static_cast<std::int64_t>(frames.size());
      frames.push_back({scene_, nullptr, std::move(state), {}, {}, {}});
    }
  }
  std::int64_t last() const override { return static_cast<std::int64_t>(frames.size()) - 1; }
  void read(std::int64_t frame, Frame& into) const override {
    into = frames[static_cast<std::size_t>(frame)];
  }

  std::vector<Frame> frames;

 private:
  std::shared_ptr<const Scene> scene_;
};

inline Body body_at(int id, double x, double y, Vec2 velocity = {}) {
  Body body;
  body.id = id;
  body.origin.spawn = id - 1;
  body.box = {x, y, 8, 8};
  body.velocity = velocity;
  return body;
}

inline State state_of(std::vector<Body> bodies) {
  State state;
  state.bodies = std::move(bodies);
  return state;
}

}  // namespace talus
