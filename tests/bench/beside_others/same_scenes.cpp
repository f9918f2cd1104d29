#include "same_scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "exact_line.h"

namespace talus::beside {
namespace {

using Values = std::vector<double>;

constexpr double kGravity = 0.2;  // px/frame^2
constexpr double kWall = 64;      // px, so thick that nothing passes it within a frame

double length(Vec2 v) { return std::hypot(v.x, v.y); }

double mass(const World& world, std::size_t i) { return world.boxes[i].at.w * world.boxes[i].at.h; }

double energy(const World& world, const Engine& engine) {
  double sum = 0;
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    const Vec2 v = engine.velocity(i);
    sum += mass(world, i) * dot(v, v) / 2;
  }
  return sum;
}

// Numbers that look random, and are the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0);
  }

 private:
  std::mt19937 bits_;
};

// A world with walls on all sides around a space of this size.
World room(double width, double height) {
  World world;
  world.width = width + 2 * kWall;
  world.height = height + 2 * kWall;
  world.walls = {{0, 0, world.width, kWall},
                 {0, kWall + height, world.width, kWall},
                 {0, kWall, kWall, height},
                 {kWall + width, kWall, kWall, height}};
  return world;
}

// ---- A cradle ----

constexpr double kCradleSpeed = 2;  // px/frame
constexpr int kInCradle = 5;

World cradle() {
  World world{.width = 256, .height = 16};
  for (int i = 0; i < kInCradle; ++i)
    world.boxes.push_back({{i == 0 ? 60.3 : 100.0 + 8 * i, 4, 8, 8}, {i == 0 ? kCradleSpeed : 0, 0}});
  return world;
}

// The last one leaves with the speed of the first, and the others stand where they touched.
Values run_cradle(const World& world, int frames, Engine& engine) {
  for (int i = 0; i < frames; ++i) engine.step();
  const double impact = (world.boxes[1].at.x - world.boxes[0].at.right()) / kCradleSpeed;  // frames
  double speed_error = 0, place_error = 0;
  for (std::size_t i = 0; i < kInCradle; ++i) {
    const bool leaves = i + 1 == kInCradle;
    const double speed = leaves ? kCradleSpeed : 0;
    const double place = 100 + 8 * static_cast<double>(i) + speed * (frames - impact);
    speed_error = std::max(speed_error, length(engine.velocity(i) - Vec2{speed, 0}));
    place_error = std::max(place_error, length(engine.box(i).position() - Vec2{place, 4}));
  }
  return {speed_error, place_error};
}

// ---- A light and a heavy box ----

World light_and_heavy() {
  World world = room(400, 256);
  world.boxes = {{{kWall + 100, kWall + 120, 8, 8}, {2, 0}},
                 {{kWall + 140, kWall + 3, 256, 250}, {-0.25, 0}}};
  return world;
}

// Whether no wall can have touched a box in the last frame.
bool is_off_walls(const World& world, const Engine& engine, std::size_t i) {
  const double reach = 2 * std::abs(engine.velocity(i).x) + 1;
  const Rect box = engine.box(i);
  return box.x - kWall > reach && world.width - kWall - box.right() > reach;
}

double momentum(const World& world, const Engine& engine) {
  double sum = 0;
  for (std::size_t i = 0; i < world.boxes.size(); ++i) sum += mass(world, i) * engine.velocity(i).x;
  return sum;
}

Values run_light_and_heavy(const World& world, int frames, Engine& engine) {
  const double power = energy(world, engine), light = mass(world, 0) * 2;
  double energy_error = 0, momentum_error = 0, before = momentum(world, engine);
  bool was_off = false;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const double now = momentum(world, engine);
    const bool is_off = is_off_walls(world, engine, 0) && is_off_walls(world, engine, 1);
    if (is_off && was_off) momentum_error = std::max(momentum_error, std::abs(now - before) / light);
    before = now;
    was_off = is_off;
    energy_error = std::max(energy_error, std::abs(energy(world, engine) / power - 1));
  }
  ExactLine line{kWall, world.width - kWall, mass(world, 0), mass(world, 1), {}, {}};
  line.light = {world.boxes[0].at.x, world.boxes[0].at.w, world.boxes[0].velocity.x};
  line.heavy = {world.boxes[1].at.x, world.boxes[1].at.w, world.boxes[1].velocity.x};
  line.run(frames);
  const double place_error =
      std::max(std::abs(engine.box(0).x - line.light.place), std::abs(engine.box(1).x - line.heavy.place));
  return {energy_error, momentum_error, place_error};
}

// ---- A gas ----

World gas() {
  World world = room(160, 160);
  Random next(7);
  for (int i = 0; i < 30; ++i) {
    const Vec2 at{kWall + 6 + 25 * (i % 6), kWall + 6 + 30.0 * (i / 6)};
    const double w = next(4, 14), h = next(4, 14);
    world.boxes.push_back({{at.x, at.y, w, h}, {next(-1.5, 1.5), next(-1.5, 1.5)}});
  }
  return world;
}

Values run_gas(const World& world, int frames, Engine& engine) {
  const double power = energy(world, engine);
  double energy_error = 0, overlap = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    energy_error = std::max(energy_error, std::abs(energy(world, engine) / power - 1));
    overlap = std::max(overlap, deepest_overlap(world, engine));
  }
  return {energy_error, overlap};
}

// ---- A slide ----

constexpr Vec2 kSlideFrom{40, 40}, kSlideTo{440, 440};

World slide() {
  World world{.width = 480, .height = 480, .gravity = kGravity, .material = kCrate};
  world.inclines = {{kSlideFrom, kSlideTo}};
  world.boxes = {{{60, 52, 8, 8}}};
  return world;
}

Values run_slide(const World& world, int frames, Engine& engine) {
  const double half = std::sqrt(0.5);  // sine and cosine of the slope
  double off = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const Rect box = engine.box(0);
    off = std::max(off, std::abs(box.bottom() - box.x) * half);
  }
  const Vec2 way = engine.box(0).position() - world.boxes[0].at.position();
  const double right = kGravity * half * (1 - world.material.friction) * frames * frames / 2;
  return {std::abs(dot(way, {half, half}) - right), off};
}

// ---- A stack and a pyramid ----

World floor_world() {
  World world{.width = 256, .height = 256, .gravity = kGravity, .material = kCrate};
  world.walls = {{0, 256 - kWall, 256, kWall}};
  return world;
}

World stack() {
  World world = floor_world();
  for (int i = 0; i < 10; ++i) world.boxes.push_back({{120, 256 - kWall - 8 * (i + 1), 8, 8}});
  return world;
}

World pyramid() {
  World world = floor_world();
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 10 - row; ++i)
      world.boxes.push_back({{60.0 + 10 * i + 5 * row, 256 - kWall - 8 * (row + 1), 8, 8}});
  return world;
}

// The last box is the one on the top.
Values run_pile(const World& world, int frames, Engine& engine) {
  double overlap = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    overlap = std::max(overlap, deepest_overlap(world, engine));
  }
  const std::size_t top = world.boxes.size() - 1;
  return {overlap, length(engine.box(top).position() - world.boxes[top].at.position())};
}

// ---- A fall ----

constexpr double kFall = 100;  // px

World fall() {
  World world = floor_world();
  world.material = kElastic;
  world.boxes = {{{120, 256 - kWall - 8 - kFall, 8, 8}}};
  return world;
}

Values run_fall(const World& world, int frames, Engine& engine) {
  const double top = world.boxes[0].at.y, takes = std::sqrt(2 * kFall / kGravity);  // frames
  double energy_error = 0, place_error = 0;
  for (int i = 1; i <= frames; ++i) {
    engine.step();
    const Vec2 v = engine.velocity(0);
    const double fallen = engine.box(0).y - top;
    const double power = dot(v, v) / 2 + kGravity * (kFall - fallen);
    energy_error = std::max(energy_error, std::abs(power / (kGravity * kFall) - 1));
    const double phase = std::remainder(i, 2 * takes);
    place_error = std::max(place_error, std::abs(fallen - kGravity * phase * phase / 2));
  }
  return {energy_error, place_error};
}

// ---- Many boxes ----

// None meets another one: all rise and fall alike, and each row goes at a speed of its own.
World flying(int bodies) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(bodies)));
  World world{.width = 24.0 * columns + 640, .height = 24.0 * columns + 640, .gravity = 0.05};
  for (int i = 0; i < bodies; ++i) {
    const int row = i / columns;
    world.boxes.push_back({{320.0 + 24 * (i % columns), 320.0 + 24 * row, 8, 8}, {0.5 * (row % 7 - 3), -3}});
  }
  return world;
}

// Crates of many sizes fall into a bin, and fill it to about a third of its width.
World bin(int bodies) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(1.6 * bodies)));
  const int rows = (bodies + columns - 1) / columns;
  const double width = 16.0 * columns, height = std::ceil(14.0 * rows / kCell) * kCell + 80;
  World world = room(width, height);
  world.gravity = kGravity;
  world.material = kCrate;
  Random next(11);
  for (int i = 0; i < bodies; ++i) {
    const double w = next(6, 10), h = next(6, 10);
    const Vec2 at{kWall + 3 + 16.0 * (i % columns) + next(0, 3), kWall + height - 14.0 * (i / columns + 1)};
    world.boxes.push_back({{at.x, at.y, w, h}, {next(-0.5, 0.5), 0}});
  }
  return world;
}

}  // namespace

double deepest_overlap(const World& world, const Engine& engine) {
  std::vector<Rect> boxes(world.boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = engine.box(i);
  double deepest = 0;
  const auto look = [&](const Rect& a, const Rect& b) {
    const double x = std::min(a.right() - b.x, b.right() - a.x);
    const double y = std::min(a.bottom() - b.y, b.bottom() - a.y);
    deepest = std::max(deepest, std::min(x, y));
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) look(boxes[i], boxes[k]);
    for (const Rect& wall : world.walls) look(boxes[i], wall);
  }
  return deepest;
}

int count_lost(const World& world, const Engine& engine) {
  int count = 0;
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    const Vec2 at = engine.box(i).center();
    if (at.x < 0 || at.y < 0 || at.x > world.width || at.y > world.height) ++count;
  }
  return count;
}

int count_moving(const World& world, Engine& engine) {
  std::vector<Vec2> before;
  for (std::size_t i = 0; i < world.boxes.size(); ++i) before.push_back(engine.box(i).position());
  engine.step();
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (length(engine.box(i).position() - before[i]) > 0.01) ++count;
  return count;
}

std::vector<ErrorScene> error_scenes() {
  const std::string energy_drift = "energy, share", overlap = "overlap, px", top = "top moved, px";
  return {{"cradle", cradle(), 40, {"speed, px/frame", "place, px"}, run_cradle},
          {"masses 1 and 1000",
           light_and_heavy(),
           1000,
           {energy_drift, "momentum, of the light one", "place, px"},
           run_light_and_heavy},
          {"30 boxes in a room", gas(), 1000, {energy_drift, overlap}, run_gas},
          {"slide", slide(), 100, {"way, px", "off the line, px"}, run_slide},
          {"stack of 10", stack(), 2000, {overlap, top}, run_pile},
          {"fall and bounce", fall(), 1000, {energy_drift, "place, px"}, run_fall},
          {"pyramid of 55", pyramid(), 1000, {overlap, top}, run_pile}};
}

std::vector<SpeedScene> speed_scenes(int bodies) {
  return {{flying(bodies), {{"flying", 120}}},
          {bin(bodies), {{"piling up", 240}, {"", 1200}, {"at rest", 240}}}};
}

}  // namespace talus::beside
