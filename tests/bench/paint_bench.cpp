// What painting a cell of the largest map costs: copying the terrain, computing its new outline, and freeing
// the old terrain; and what compiling the whole map costs.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

#include <talus/collision/terrain.h>

namespace talus {
namespace {

constexpr int kSide = 4096;     // cells
constexpr int kEdits = 10'000;  // edits in a run
constexpr std::uint8_t kEmpty = 0, kSolid = 1, kRising = 2, kFalling = 3;

// sparse: 25 % of the cells are solid, and 3 % have a slope of 16 x 8 px to either side. dense: every cell is
// solid or has a slope.
enum Map { kSparse, kDense };

TileNumber random_tile(std::mt19937& random, Map map) {
  const auto percent = random() % 100;
  if (percent < (map == kDense ? 50 : 25)) return kSolid;
  if (percent < (map == kDense ? 100 : 28)) return random() % 2 == 0 ? kRising : kFalling;
  return kEmpty;
}

Terrain large_terrain(std::mt19937& random, Map map) {
  std::vector<TileNumber> cells(static_cast<std::size_t>(kSide) * kSide);
  for (TileNumber& cell : cells) cell = random_tile(random, map);
  TerrainSource source;
  source.width = source.height = kSide;
  source.cells = cells;
  source.shapes[kSolid].kind = TileShape::Kind::solid;
  source.shapes[kRising] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 8}};
  source.shapes[kFalling] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {8, 0}};
  return Terrain(source);
}

void compile(benchmark::State& state, Map map) {
  for (auto _ : state) {
    std::mt19937 random(1);
    benchmark::DoNotOptimize(large_terrain(random, map).has_pieces());
  }
}

void paint_cell(benchmark::State& state, Map map) {
  std::mt19937 random(1);
  Terrain terrain = large_terrain(random, map);
  std::vector<double> times;  // ms
  for (auto _ : state) {
    const Cell cell{static_cast<int>(random() % kSide), static_cast<int>(random() % kSide)};
    const auto tile =
        static_cast<TileNumber>((terrain.tile_at(cell) + 1 + random() % 3) % 4);  // another tile
    const auto begin = std::chrono::steady_clock::now();
    Terrain edited = terrain;
    edited.set_cell(cell, tile);
    terrain = std::move(edited);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    state.SetIterationTime(time.count());
    times.push_back(time.count() * 1000);
  }
  std::sort(times.begin(), times.end());
  state.counters["mean_ms"] =
      std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["p999_ms"] = times[times.size() * 999 / 1000];
  state.counters["max_ms"] = times.back();
}
BENCHMARK_CAPTURE(paint_cell, sparse, kSparse)
    ->Iterations(kEdits)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(paint_cell, dense, kDense)
    ->Iterations(kEdits)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(compile, sparse, kSparse)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(compile, dense, kDense)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace talus
