// What a step of the exact solver costs for each body, feature by feature.
#include <benchmark/benchmark.h>

#include <talus/level/level.h>
#include "sim/exact_solver.h"

namespace talus {
namespace {

constexpr int kBodies = 1'000;
constexpr std::int64_t kRound = 64;  // frames until all bodies start again, before most have come to rest

enum Ground { kTilesOnly, kSlopesToo, kCurvesToo, kOneWayToo };

// Floors with steps in them over a map of 240 x 136 tiles. Every eighth step is a slope, an arc or a one-way
// tile if the ground has them.
Level level_with(Ground ground, BodyKind kind) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = 0;
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[1] = 1;
  flags[2] = 4;
  level.tile_shapes[3] = {TileShape::Kind::solid, TileShape::Side::floor, true, 1, {}};
  for (Cell c{0, 0}; c.y < 136; ++c.y) {
    for (c.x = 0; c.x < 240; ++c.x) {
      if (c.y % 8 == 7) level.map.set(c, 1);
      if (c.y % 8 != 6 || c.x % 8 != 3) continue;
      level.map.set(c, ground == kSlopesToo ? 2 : ground == kOneWayToo ? 3 : 1);
      if (ground != kCurvesToo) continue;
      const double x = c.x * 8.0, y = c.y * 8.0 + 8;
      level.map.set(c, 0);
      level.curves.push_back({"", {Arc{{x + 8, y + 6}, 10, x, x + 16, true}, Curve::Faces::up}, ""});
    }
  }
  for (int i = 0; i < kBodies; ++i) {
    Spawn spawn;
    spawn.position = {(i % 50) * 38.0 + 5, (i / 50 % 16) * 64.0 + 20};
    spawn.velocity = {i % 7 - 3.0, 0};
    spawn.kind = kind;
    level.spawns.push_back(spawn);
  }
  return level;
}

void step(benchmark::State& state, Ground ground, BodyKind kind) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level_with(ground, kind)));
  const auto solver = make_exact_solver(scene);
  const State start = initial_state(*scene);
  State bodies = start;
  Input input;
  for (auto _ : state) {
    if (bodies.frame == kRound) bodies = start;
    input.right = bodies.frame % 64 < 32;
    input.left = !input.right;
    solver->step(bodies, input, nullptr);
  }
  state.counters["per_body"] = benchmark::Counter(static_cast<double>(state.iterations()) * kBodies,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(step, tiles, kTilesOnly, BodyKind::ball);
BENCHMARK_CAPTURE(step, slopes, kSlopesToo, BodyKind::ball);
BENCHMARK_CAPTURE(step, curves, kCurvesToo, BodyKind::ball);
BENCHMARK_CAPTURE(step, one_way, kOneWayToo, BodyKind::ball);
BENCHMARK_CAPTURE(step, players, kTilesOnly, BodyKind::player);

}  // namespace
}  // namespace talus
