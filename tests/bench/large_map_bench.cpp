// What a map of Tiled with 4096x4096 cells, three layers and 2,000 tiles costs: reading it and compiling its
// ground, and painting a cell of it. TALUS_BENCH_MAP: one that tests/bench/make_large_map has written.
#include <sys/resource.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>

#include <talus/formats/format.h>
#include <talus/sim/scene.h>
#include "cli/timing.h"
#include "level/level_version.h"

namespace talus {
namespace {

std::optional<Level> large_map() {
  const char* map = std::getenv("TALUS_BENCH_MAP");
  if (map == nullptr) return std::nullopt;
  FormatResult<LoadedLevel> loaded = load_level(map);
  if (!loaded) return std::nullopt;
  loaded->level.tuning.solver = SolverKind::exact;
  return std::move(loaded->level);
}

double peak_mb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void open_large_map(benchmark::State& state) {
  for (auto _ : state) {
    const std::optional<Level> level = large_map();
    if (!level) return state.SkipWithError("TALUS_BENCH_MAP names no map");
    benchmark::DoNotOptimize(compile_scene(*level).ground_lines);
  }
  state.counters["peak_MB"] = peak_mb();
}
BENCHMARK(open_large_map)->Iterations(1)->Unit(benchmark::kSecond);

// A tile of the chosen layer becomes one from elsewhere in it: the cell of the level, its ground, and the
// version of the level that a frame is played with.
void paint_large_map(benchmark::State& state) {
  std::optional<Level> level = large_map();
  if (!level) return state.SkipWithError("TALUS_BENCH_MAP names no map");
  Scene scene = compile_scene(*level);
  LevelVersion version = version_of(*level);
  std::mt19937 random(1);
  const auto any_cell = [&] {
    return Cell{static_cast<int>(random() % static_cast<unsigned>(level->map.width())),
                static_cast<int>(random() % static_cast<unsigned>(level->map.height()))};
  };
  std::vector<double> times;  // ms
  for (auto _ : state) {
    const std::array<Cell, 1> cell = {any_cell()};
    const double ns = nanoseconds([&] {
      level->map.set(cell[0], level->map.at(any_cell()));
      scene = recompile_scene(scene, *level, cell);
      version = version_of(*level, version, cell);
    });
    state.SetIterationTime(ns / 1e9);
    times.push_back(ns / 1e6);
  }
  std::sort(times.begin(), times.end());
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["p99_ms"] = times[times.size() * 99 / 100];
  state.counters["max_ms"] = times.back();
}
BENCHMARK(paint_large_map)->Iterations(2000)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace talus
