// Levels of bodies that meet, and their run.
#pragma once

#include <initializer_list>
#include <memory>
#include <string_view>

#include <talus/sim/solver.h>
#include "level_picture.h"

namespace talus {

// Nothing slows bodies down but this bounce.
inline void let_bodies_meet(Tuning& t, double gravity, double bounce = 1) {
  t.solver = SolverKind::exact;
  t.shared.bodies = static_cast<double>(BodyPairs::meet);
  t.shared.fall_blend = t.shared.drift_blend = 0;
  t.shared.floor_bounce = t.shared.wall_bounce = bounce;
  t.exact.gravity = gravity;
  t.exact.rebound = 1;
}

// In both, nothing slows bodies down but the bounce.
inline Level meeting_level(std::initializer_list<std::string_view> rows, double gravity, double bounce = 1) {
  Level level = level_of(rows);
  let_bodies_meet(level.tuning, gravity, bounce);
  return level;
}
// Without any ground.
inline Level open_level(double gravity, double bounce) {
  Level level;
  level.map = TileMap(60, 30);
  let_bodies_meet(level.tuning, gravity, bounce);
  return level;
}

// A room of tiles, with a floor, two walls and no ceiling. width and height: cells, with those.
inline Level room_level(int width, int height, double gravity) {
  Level level = open_level(gravity, 0);
  level.map = TileMap(width, height);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 0; x < width; ++x) level.map.set({x, height - 1}, 1);
  for (int y = 0; y < height; ++y) {
    for (const int x : {0, width - 1}) level.map.set({x, y}, 1);
  }
  return level;
}

inline void add_body(Level& level, BodyKind kind, Vec2 at, Vec2 velocity = {}, Vec2 size = {8, 8}) {
  level.spawns.push_back(
      {.name = "", .position = at, .velocity = velocity, .extra = "", .kind = kind, .size = size});
}

struct MeetingRun {
  explicit MeetingRun(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        state(initial_state(*scene)) {}
  void step(int times = 1, const Input& input = {}) {
    for (int i = 0; i < times; ++i) solver->step(state, input);
  }
  const Body& body(std::size_t index) const { return state.bodies[index]; }

  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State state;
};

}  // namespace talus
