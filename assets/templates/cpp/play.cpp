// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "play.h"

#include <iostream>

namespace game {

Play::Play(const talus::Level& level)
    : level_(level),
      scene_(std::make_shared<const talus::Scene>(talus::compile_scene(level_))),
      solver_(talus::make_solver(scene_)),
      state_(talus::initial_state(*scene_)),
      camera_(level_),
      layers_(level_),
      bodies_(level_) {}

void Play::draw(Painter& painter) {
  camera_.place(painter, state_);
  painter.clear(layers_.background());
  const double time = static_cast<double>(state_.frame) * 1000 / kStepsPerSecond;  // ms
  layers_.draw(painter, time);
  bodies_.draw(painter, state_, time);
}

std::unique_ptr<Play> load(const std::string& file) {
  const auto loaded = talus::load_level(file);
  if (loaded) return std::make_unique<Play>(loaded->level);
  std::cerr << talus::to_string(loaded.error(), file) << '\n';
  return nullptr;
}

}  // namespace game
