// What a move and a projection cost among 10,000 balls on a map of 5,670 tiles, as in the article's scene.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include <talus/collision/world.h>

namespace talus {
namespace {

constexpr int kBalls = 10'000;
constexpr int kTiles = 5'670;

struct Scene {
  World world;
  std::vector<char> is_ball = std::vector<char>(1 + kTiles + kBalls);  // by the index of the item
  std::vector<ItemId> balls;
  std::vector<Vec2> velocities;

  // Scatters tiles and balls over a map of 240 x 136 tiles with a solid border, and adds them in map order,
  // column by column.
  explicit Scene(World::Mode mode) : world(24, mode) {
    std::mt19937 random(1);
    enum Content : char { kEmpty, kTile, kBall };
    std::vector<Content> map(240 * 136, kEmpty);
    std::vector<std::size_t> inner;
    for (std::size_t cell = 0; cell < map.size(); ++cell) {
      const bool border = cell / 136 == 0 || cell / 136 == 239 || cell % 136 == 0 || cell % 136 == 135;
      if (border) {
        map[cell] = kTile;
      } else {
        inner.push_back(cell);
      }
    }
    std::shuffle(inner.begin(), inner.end(), random);
    const std::size_t tiles = kTiles - (map.size() - inner.size());
    for (std::size_t i = 0; i < tiles + kBalls; ++i) map[inner[i]] = i < tiles ? kTile : kBall;
    for (std::size_t cell = 0; cell < map.size(); ++cell) {
      if (map[cell] == kEmpty) continue;
      const ItemId item =
          world.add({8.0 * static_cast<double>(cell / 136), 8.0 * static_cast<double>(cell % 136), 8, 8});
      if (map[cell] == kTile) continue;
      is_ball[item.index] = true;
      balls.push_back(item);
      velocities.push_back({static_cast<double>(random() % 64) / 16 - 2, 0});
    }
  }

  Response reaction(ItemId other) const { return is_ball[other.index] ? Response::ignore : Response::slide; }
};

void report(benchmark::State& state) {
  state.counters["per_ball"] = benchmark::Counter(static_cast<double>(state.iterations()) * kBalls,
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void fall(benchmark::State& state, World::Mode mode) {
  Scene scene(mode);
  std::vector<Collision> hits;
  for (auto _ : state) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
      Vec2& v = scene.velocities[i];
      v = {0.97 * v.x, 0.925 * v.y + 0.375};
      const Vec2 from = scene.world.rect(scene.balls[i]).position();
      v = scene.world.move(
              scene.balls[i], from + v, [&](ItemId, ItemId other) { return scene.reaction(other); }, hits) -
          from;
    }
  }
  report(state);
}

void project(benchmark::State& state) {
  const Scene scene(World::Mode::faithful);
  std::vector<Collision> hits;
  for (auto _ : state) {
    for (const ItemId ball : scene.balls) {
      const Rect rect = scene.world.rect(ball);
      scene.world.project(
          ball, rect, rect.position() + Vec2{1, 3},
          [&](ItemId, ItemId other) { return scene.reaction(other); }, hits);
      benchmark::DoNotOptimize(hits.data());
    }
  }
  report(state);
}

BENCHMARK_CAPTURE(fall, faithful, World::Mode::faithful);
BENCHMARK_CAPTURE(fall, robust, World::Mode::robust);
BENCHMARK(project);

}  // namespace
}  // namespace talus
