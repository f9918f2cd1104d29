// Elastic bodies that meet without gravity.
#include <algorithm>
#include <cmath>

#include "exact_line.h"
#include "scene_parts.h"

namespace talus::beside {
namespace {

// ---- A cradle ----

constexpr double kCradleSpeed = 2;  // px/frame
constexpr int kInCradle = 5;

World cradle(bool is_round) {
  World world{.width = 256, .height = 16};
  for (int i = 0; i < kInCradle; ++i)
    world.bodies.push_back(
        {{i == 0 ? 60.3 : 100.0 + 8 * i, 4, 8, 8}, {i == 0 ? kCradleSpeed : 0, 0}, is_round});
  return world;
}

// The last one leaves with the speed of the first, and the others stand where they touched.
Values run_cradle(const World& world, int frames, Engine& engine) {
  for (int i = 0; i < frames; ++i) engine.step();
  const double impact = (world.bodies[1].at.x - world.bodies[0].at.right()) / kCradleSpeed;  // frames
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
  world.bodies = {{{kWall + 100, kWall + 120, 8, 8}, {2, 0}},
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
  for (std::size_t i = 0; i < world.bodies.size(); ++i) sum += mass(world, i) * engine.velocity(i).x;
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
  line.light = {world.bodies[0].at.x, world.bodies[0].at.w, world.bodies[0].velocity.x};
  line.heavy = {world.bodies[1].at.x, world.bodies[1].at.w, world.bodies[1].velocity.x};
  line.run(frames);
  const double place_error =
      std::max(std::abs(engine.box(0).x - line.light.place), std::abs(engine.box(1).x - line.heavy.place));
  return {energy_error, momentum_error, place_error};
}

// ---- A gas ----

// So many of the thirty are round, evenly among the others.
World gas(int circles) {
  World world = room(160, 160);
  Random next(7);
  for (int i = 0; i < 30; ++i) {
    const Vec2 at{kWall + 6 + 25 * (i % 6), kWall + 6 + 30.0 * (i / 6)};
    const bool is_round = i * circles / 30 != (i + 1) * circles / 30;
    const double w = next(4, 14), h = is_round ? w : next(4, 14);
    world.bodies.push_back({{at.x, at.y, w, h}, {next(-1.5, 1.5), next(-1.5, 1.5)}, is_round});
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

}  // namespace

std::vector<ErrorScene> impact_scenes() {
  const std::vector<std::string> of_cradle{"speed, px/frame", kPlace}, of_gas{kEnergy, kOverlap};
  return {{"cradle", cradle(false), 40, of_cradle, run_cradle},
          {"cradle of circles", cradle(true), 40, of_cradle, run_cradle},
          {"masses 1 and 1000",
           light_and_heavy(),
           1000,
           {kEnergy, "momentum, of the light one", kPlace},
           run_light_and_heavy},
          {"30 boxes in a room", gas(0), 1000, of_gas, run_gas},
          {"30 circles in a room", gas(30), 1000, of_gas, run_gas},
          {"15 boxes and 15 circles", gas(15), 1000, of_gas, run_gas}};
}

}  // namespace talus::beside
