// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// A level that is played: its bodies move by step(), and draw() shows them.
#pragma once

#include <talus/formats/format.h>
#include <talus/sim/solver.h>

#include <memory>
#include <string>

#include "bodies.h"
#include "layers.h"
#include "level_camera.h"

namespace game {

inline constexpr int kStepsPerSecond = 60;

class Play {
 public:
  explicit Play(const talus::Level& level);
  Play(const Play&) = delete;  // its parts refer to its level
  void step(const talus::Input& input) { solver_->step(state_, input); }
  void draw(Painter& painter);
  const talus::State& state() const { return state_; }

 private:
  talus::Level level_;
  std::shared_ptr<const talus::Scene> scene_;
  std::unique_ptr<talus::Solver> solver_;
  talus::State state_;
  Camera camera_;
  Layers layers_;
  Bodies bodies_;
};

// Null: the file cannot be read, and it was said why.
std::unique_ptr<Play> load(const std::string& file);

}  // namespace game
