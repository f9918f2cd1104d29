// Bodies that stand on one another, and many at once.
#include <algorithm>
#include <cmath>

#include "scene_parts.h"

namespace talus::beside {
namespace {

// ---- A stack and a pyramid ----

World stack() {
  World world = floor_world(kCrate);
  for (int i = 0; i < 10; ++i) world.bodies.push_back({{120, 256 - kWall - 8 * (i + 1), 8, 8}});
  return world;
}

World pyramid() {
  World world = floor_world(kCrate);
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 10 - row; ++i)
      world.bodies.push_back({{60.0 + 10 * i + 5 * row, 256 - kWall - 8 * (row + 1), 8, 8}});
  return world;
}

// Discs of 8 px in so many rows. They can stand: a friction of 0.27 holds two rows, and 0.48 holds four.
World pyramid_of_discs(int rows) {
  World world = floor_world(kDisc);
  for (int row = 0; row < rows; ++row) {
    const double y = 256 - kWall - 8 - row * 8 * std::sqrt(0.75);
    for (int i = 0; i < rows - row; ++i)
      world.bodies.push_back({{100.0 + 8 * i + 4 * row, y, 8, 8}, {}, true});
  }
  return world;
}

// The last body is the one on the top.
Values run_pile(const World& world, int frames, Engine& engine) {
  double overlap = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    overlap = std::max(overlap, deepest_overlap(world, engine));
  }
  const std::size_t top = world.bodies.size() - 1;
  return {overlap, length(engine.box(top).position() - world.bodies[top].at.position())};
}

// ---- Marbles that part ----

// One stands on two that touch, and pushes them apart.
World marbles() {
  World world = pyramid_of_discs(2);
  world.material = kElastic;
  return world;
}

// It leaves them where they are fastest: where the cosine c of half of the angle between them solves
// c^3 + 3 c = 2 c0, with c0 at the start. They keep that speed.
Values run_marbles(const World& world, int frames, Engine& engine) {
  const double highest = world.bodies[2].at.y, height = world.bodies[0].at.y - highest;
  double energy_error = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const double gained = energy(world, engine) / mass(world, 0);
    const double fallen = engine.box(2).y - highest;
    energy_error = std::max(energy_error, std::abs(gained / kGravity - fallen) / height);
  }
  const double radius = world.bodies[0].at.w / 2, start = std::sqrt(0.75);
  const double part = std::cbrt(start + std::sqrt(start * start + 1));
  const double c = part - 1 / part;
  const double speed = 2 * c * std::sqrt(kGravity * radius * (start - c) / (1 + c * c));
  return {energy_error, std::max(length(engine.velocity(0) - Vec2{-speed, 0}),
                                 length(engine.velocity(1) - Vec2{speed, 0}))};
}

// ---- Many bodies ----

// None meets another one: all rise and fall alike, and each row goes at a speed of its own.
World flying(int bodies, bool is_round) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(bodies)));
  World world{.width = 24.0 * columns + 640, .height = 24.0 * columns + 640, .gravity = 0.05};
  for (int i = 0; i < bodies; ++i) {
    const int row = i / columns;
    world.bodies.push_back(
        {{320.0 + 24 * (i % columns), 320.0 + 24 * row, 8, 8}, {0.5 * (row % 7 - 3), -3}, is_round});
  }
  return world;
}

// Crates or discs of many sizes fall into a bin, and fill it to about a third of its width.
World bin(int bodies, bool is_round) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(1.6 * bodies)));
  const int rows = (bodies + columns - 1) / columns;
  const double width = 16.0 * columns, height = std::ceil(14.0 * rows / kCell) * kCell + 80;
  World world = room(width, height);
  world.gravity = kGravity;
  world.material = is_round ? kDisc : kCrate;
  Random next(11);
  for (int i = 0; i < bodies; ++i) {
    const double w = next(6, 10), h = is_round ? w : next(6, 10);
    const Vec2 at{kWall + 3 + 16.0 * (i % columns) + next(0, 3), kWall + height - 14.0 * (i / columns + 1)};
    world.bodies.push_back({{at.x, at.y, w, h}, {next(-0.5, 0.5), 0}, is_round});
  }
  return world;
}

}  // namespace

std::vector<ErrorScene> pile_scenes() {
  const std::vector<std::string> measures{kOverlap, "top moved, px"};
  return {{"stack of 10", stack(), 2000, measures, run_pile},
          {"pyramid of 55", pyramid(), 1000, measures, run_pile},
          {"pyramid of 3 discs", pyramid_of_discs(2), 1000, measures, run_pile},
          {"pyramid of 10 discs", pyramid_of_discs(4), 1000, measures, run_pile},
          {"3 marbles part", marbles(), 40, {kEnergy, "speed, px/frame"}, run_marbles}};
}

std::vector<SpeedScene> speed_scenes(int bodies) {
  return {{flying(bodies, false), {{"boxes flying", 120}}},
          {flying(bodies, true), {{"circles flying", 120}}},
          {bin(bodies, false), {{"boxes piling up", 240}, {"", 1200}, {"boxes at rest", 240}}},
          {bin(bodies, true), {{"circles piling up", 240}, {"", 1200}, {"circles at rest", 240}}}};
}

}  // namespace talus::beside
