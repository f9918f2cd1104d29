// What painting a cell of the largest map costs: a copy of the terrain, as undo keeps one, and its new
// outline.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

#include "collision/terrain.h"

namespace talus {
namespace {

constexpr int kSide = 4096;     // cells
constexpr int kEdits = 10'000;  // of one run
constexpr std::uint8_t kEmpty = 0, kSolid = 1, kRising = 2, kFalling = 3;

// 25 % of the cells are solid, and 3 % have a slope of 16 x 8 px, rising to either side.
std::uint8_t random_tile(std::mt19937& random) {
  const auto percent = random() % 100;
  if (percent < 25) return kSolid;
  if (percent < 28) return random() % 2 == 0 ? kRising : kFalling;
  return kEmpty;
}

Terrain large_terrain(std::mt19937& random) {
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(kSide) * kSide);
  for (std::uint8_t& cell : cells) cell = random_tile(random);
  TerrainSource source;
  source.width = source.height = kSide;
  source.cells = cells;
  source.shapes[kSolid].kind = TileShape::Kind::solid;
  source.shapes[kRising] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 8}};
  source.shapes[kFalling] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {8, 0}};
  return Terrain(source);
}

void paint_cell(benchmark::State& state) {
  std::mt19937 random(1);
  Terrain terrain = large_terrain(random);
  std::vector<double> times;  // ms
  for (auto _ : state) {
    const Cell cell{static_cast<int>(random() % kSide), static_cast<int>(random() % kSide)};
    const auto tile = static_cast<std::uint8_t>((terrain.tile_at(cell) + 1 + random() % 3) % 4);  // another
    const auto begin = std::chrono::steady_clock::now();
    Terrain edited = terrain;
    edited.set_cell(cell, tile);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    terrain = std::move(edited);
    state.SetIterationTime(time.count());
    times.push_back(time.count() * 1000);
  }
  std::sort(times.begin(), times.end());
  state.counters["mean_ms"] =
      std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["max_ms"] = times.back();
}
BENCHMARK(paint_cell)->Iterations(kEdits)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace talus
