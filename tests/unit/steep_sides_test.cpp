// The exact solver at sides that are too steep to stand on: along them, into their corners, and between two.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include <talus/sim/solver.h>
#include "collision/ground_queries.h"

namespace talus::steep_sides_test {

Level level_with_floor() {
  Level level;
  level.map = TileMap(30, 20);
  level.tuning.solver = SolverKind::exact;
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 0; x < 30; ++x) level.map.set({x, 19}, 1);
  level.spawns.emplace_back().kind = BodyKind::player;
  return level;
}

void put_polygon(Level& level, Cell cell, TileNumber tile, std::vector<Vec2> points) {
  level.tile_shapes[tile].kind = TileShape::Kind::polygon;
  level.tile_shapes[tile].points = std::move(points);
  level.map.set(cell, tile);
}

// A V of two sides of 40 px, around x = 120.
Level level_with_wedge() {
  Level level = level_with_floor();
  put_polygon(level, {13, 10}, 2, {{0, 0}, {16, 40}, {0, 40}});
  put_polygon(level, {15, 10}, 3, {{16, 0}, {16, 40}, {0, 40}});
  return level;
}

struct Play {
  explicit Play(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        state(initial_state(*scene)) {}
  const Body& step(bool left, bool right, bool jump) {
    Input input;
    input.left = left;
    input.right = right;
    input.jump = jump;
    solver->step(state, input);
    return state.bodies.front();
  }
  bool is_in_ground() const {
    const Body& body = state.bodies.front();
    return overlaps_ground(*scene->ground, body.box, body.foot);
  }
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State state;
};

// It came through: rounding along a side of 324 px for each px put it beside the end of the next one.
TEST(SteepSides, ABodyThatSlidesUpALeaningSideStopsInTheCorner) {
  for (const double start : {75.0, 75.37, 76.1}) {
    Level level = level_with_floor();
    put_polygon(
        level, {11, 13}, 2,
        {{13.6328125, 6.13671875}, {6.5703125, 11.2265625}, {6.5546875, 6.1640625}, {2.5, 5.5}, {2.5, 1}});
    Spawn& player = level.spawns.front();
    player.position = {start, 137};
    player.size = {10, 15};
    player.foot = Foot::box;
    level.tuning.player.run_speed = 1.5;
    Play play(level);
    for (int frame = 1; frame <= 60; ++frame) {
      play.step(false, frame >= 3, frame >= 3 && frame < 15);
      EXPECT_FALSE(play.is_in_ground()) << start << ", frame " << frame;
    }
  }
}

// Some did not stand, fell faster and faster without a motion, and no key freed them.
TEST(SteepSides, ABodyStandsBetweenTwoAndJumpsOut) {
  for (const Foot foot : {Foot::centre, Foot::box}) {
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(i);
      Level level = level_with_wedge();
      level.spawns.front().foot = foot;
      level.spawns.front().position = {107 + 0.93 * i, 60};
      Play play(level);
      for (int frame = 0; frame < 120; ++frame) play.step(false, false, false);
      const Body rest = play.state.bodies.front();
      EXPECT_TRUE(rest.gait.grounded);
      EXPECT_EQ(rest.velocity.y, 0);
      EXPECT_NEAR(rest.box.x, 116, 1e-6);
      const Body& after = play.step(false, false, false);
      EXPECT_TRUE(after.gait.grounded);
      EXPECT_EQ(after.box, rest.box);
      play.step(false, true, false);
      EXPECT_TRUE(play.state.bodies.front().gait.grounded) << "a key to the side does not lift it";
      for (int frame = 0; frame < 8; ++frame) play.step(false, false, true);
      EXPECT_LT(play.state.bodies.front().box.y, rest.box.y - 8);
    }
  }
}

// One side alone does not hold it up.
TEST(SteepSides, ABodyBesideOneSlidesDown) {
  Level level = level_with_wedge();
  level.map.set({15, 10}, 0);
  level.spawns.front().position = {107, 60};
  Play play(level);
  for (int frame = 0; frame < 40; ++frame) {
    const Body& body = play.step(false, false, false);
    EXPECT_FALSE(body.gait.grounded && body.box.bottom() < 118);
  }
  EXPECT_GT(play.state.bodies.front().box.y - 60, 50);
}

// It lost its floor for a frame: rounding put it a little past the end of that floor.
TEST(SteepSides, ABodyThatWalksToTheFootOfOneKeepsItsFloor) {
  for (const double start : {100.74, 100.37, 100.1}) {
    Level level = level_with_floor();
    put_polygon(level, {12, 11}, 2, {{4, 0}, {43.25, 30.75}, {4, 40}});
    put_polygon(level, {11, 7}, 3, {{1.5, 6.75}, {12, 32}, {1.5, 32}});
    Spawn& player = level.spawns.front();
    player.size = {1, 1};
    player.position = {start - 0.5, 88 + (start - 100) * 30.75 / 39.25 - 1.001};
    level.tuning.player.run_speed = 0.075;
    Play play(level);
    for (int frame = 1; frame <= 40; ++frame) {
      const Body& body = play.step(frame > 2, false, false);
      EXPECT_TRUE(frame <= 2 || body.gait.grounded) << start << ", frame " << frame;
    }
    EXPECT_EQ(play.state.bodies.front().box.x, 99.5);
  }
}

TEST(SteepSides, ABodyStandsBetweenOneAndAWall) {
  Level level = level_with_wedge();
  level.map.set({15, 10}, 0);
  for (int y = 10; y < 16; ++y) level.map.set({15, y}, 1);
  level.spawns.front().position = {110, 60};
  Play play(level);
  for (int frame = 0; frame < 120; ++frame) play.step(false, false, false);
  const double rest = play.state.bodies.front().box.y;
  EXPECT_TRUE(play.state.bodies.front().gait.grounded);
  EXPECT_LT(rest, 119);
  for (int frame = 0; frame < 8; ++frame) play.step(false, false, true);
  EXPECT_LT(play.state.bodies.front().box.y, rest - 8);
}

}  // namespace talus::steep_sides_test
