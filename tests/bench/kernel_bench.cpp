// Compares the exact solver with the hand-written kernel of `talus bench`: 10,000 balls that do not collide,
// from their start on, without a recording. The two take turns frame by frame, so that other work of the
// machine slows both. TALUS_BENCH_CART: a level or cart to fall on, instead of a scattered map.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <random>
#include <string>

#include <talus/formats/format.h>
#include <talus/sim/solver.h>
#include "cli/bench_balls.h"
#include "cli/bench_kernel.h"
#include "cli/timing.h"

namespace talus {
namespace {

constexpr int kBalls = 10'000;
constexpr std::uint8_t kSolid = 1, kSlope = 2;

// 240 x 136 cells with about 5,670 solids and slopes within a solid border.
Level scattered_level() {
  Level level;
  level.sheet(SheetId::tiles).flags[kSolid] = static_cast<std::uint8_t>(1 << level.roles.solid);
  level.sheet(SheetId::tiles).flags[kSlope] = static_cast<std::uint8_t>(1 << level.roles.up_slope);
  std::mt19937 random(1);
  const TileMap& map = level.map;
  for (Cell c{0, 0}; c.y < map.height(); ++c.y) {
    for (c.x = 0; c.x < map.width(); ++c.x) {
      const bool border = c.x == 0 || c.y == 0 || c.x == map.width() - 1 || c.y == map.height() - 1;
      const auto dice = random() % 1000;
      if (border || dice < 130) level.map.set(c, kSolid);
      if (!border && dice >= 130 && dice < 155) level.map.set(c, kSlope);
    }
  }
  return level;
}

std::optional<Level> level_to_fall_on() {
  const char* cart = std::getenv("TALUS_BENCH_CART");
  if (cart == nullptr) return scattered_level();
  FormatResult<LoadedLevel> loaded = load_level(cart);
  if (!loaded) return std::nullopt;
  return std::move(loaded->level);
}

void against_kernel(benchmark::State& bench) {
  std::optional<Level> level = level_to_fall_on();
  if (!level) return bench.SkipWithError("TALUS_BENCH_CART names no level");
  level->tuning.solver = SolverKind::exact;
  level->tuning.shared.bodies = 0;
  if (!spawn_balls(*level, kBalls, 1)) return bench.SkipWithError("the level has too few free cells");
  const auto scene = std::make_shared<const Scene>(compile_scene(*level));
  const auto solver = make_solver(scene);
  const State start = initial_state(*scene);
  const auto bodies = static_cast<double>(start.bodies.size());
  std::vector<double> exact_ns, kernel_ns, ratios;
  for (auto _ : bench) {
    State state = start;
    BenchKernel kernel(*level, start);
    for (std::int64_t frame = 0; frame < bench.range(0); ++frame) {
      exact_ns.push_back(nanoseconds([&] { solver->step(state, {}); }) / bodies);
      kernel_ns.push_back(nanoseconds([&] { kernel.step(); }) / bodies);
      ratios.push_back(exact_ns.back() / kernel_ns.back());
    }
    benchmark::DoNotOptimize(kernel.checksum());
  }
  bench.counters["exact_ns"] = median(exact_ns);
  bench.counters["kernel_ns"] = median(kernel_ns);
  bench.counters["ratio"] = median(ratios);
}
BENCHMARK(against_kernel)
    ->ArgName("frames")
    ->Arg(60)
    ->Arg(120)
    ->Arg(300)
    ->Arg(600)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace talus
