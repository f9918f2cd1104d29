// The bump solver keeps bodies on the line of a slope, with its true normal, by move() alone.

#include "sim/bump_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include <talus/formats/format.h>
#include "level_picture.h"
#include "paths.h"

namespace talus::bump_solver_test {

// The ball rolls at a constant speed: it neither bounces nor slows down.
Level walking(Level level, double speed) {
  SharedTuning& t = level.tuning.shared;
  t.drift_speed = speed;
  t.drift_blend = 1;
  t.floor_bounce = t.slope_bounce = t.wall_bounce = 0;
  t.floor_grip = 1;
  level.tuning.solver = SolverKind::bump;
  return level;
}

std::shared_ptr<const Scene> scene_of(const Level& level) {
  return std::make_shared<const Scene>(compile_scene(level));
}

void add_ball(Level& level, Vec2 position, Vec2 velocity) {
  Spawn& spawn = level.spawns.emplace_back();
  spawn.position = position;
  spawn.velocity = velocity;
}

// A hill: up from y = 24 to 16 over x = 24..40, and down again until x = 72.
Level hill() {
  return level_of({"..........",   //
                   "..........",   //
                   "o../-#\\-..",  //
                   "##########"});
}

// The y of the hill's line under a box of width 8 at x.
double floor_under(double x) {
  const auto at = [](double c) {
    if (c <= 24 || c >= 64) return 24.0;
    if (c < 40) return 24 - (c - 24) / 2;
    return c <= 48 ? 16.0 : 16 + (c - 48) / 2;
  };
  double lowest = std::min(at(x), at(x + 8));
  for (const double bend : {40.0, 48.0}) {
    if (bend > x && bend < x + 8) lowest = std::min(lowest, at(bend));
  }
  return lowest;
}

TEST(BumpSolver, RollsUpASlopeAndDownTheNextWithoutSinkingIn) {
  for (const double speed : {0.5, 0.75, 1.0}) {
    const auto scene = scene_of(walking(hill(), speed));
    BumpSolver solver(scene);
    State state = initial_state(*scene);
    int on_slopes = 0;
    for (int i = 0; i < 200 && state.bodies[0].box.x < 66; ++i) {
      solver.step(state, {}, nullptr);
      const Rect& box = state.bodies[0].box;
      const double gap = floor_under(box.x) - box.bottom();
      EXPECT_GE(gap, -1e-9) << "speed " << speed << " x " << box.x;
      EXPECT_LT(gap, 0.75) << "speed " << speed << " x " << box.x;
      on_slopes += box.x > 16 && box.x < 32 && std::abs(gap) < 1e-9;
    }
    EXPECT_GE(state.bodies[0].box.x, 66) << "speed " << speed;
    EXPECT_GT(on_slopes, 10) << "speed " << speed;
  }
}

TEST(BumpSolver, ABallRollsDownOnTheLineOfTheSlope) {
  Level level = level_of({"......",  //
                          "......",  //
                          "./-...",  //
                          "######"});
  add_ball(level, {10, 11}, {});
  level.tuning.solver = SolverKind::bump;
  const auto scene = scene_of(level);
  BumpSolver solver(scene);
  State state = initial_state(*scene);
  double last = state.bodies[0].box.x;
  for (int i = 0; i < 20; ++i) {
    solver.step(state, {}, nullptr);
    const Rect& box = state.bodies[0].box;
    EXPECT_LT(box.x, last) << "frame " << i;
    last = box.x;
    // The right bottom corner stands on the floor: y = 24 - (x - 8) / 2.
    if (box.right() <= 8) break;
    EXPECT_NEAR(box.bottom(), 24 - (box.right() - 8) / 2, 1e-12) << "frame " << i;
  }
}

TEST(BumpSolver, StandingIsOneCheck) {
  const auto scene = scene_of(walking(hill(), 1));
  BumpSolver solver(scene);
  State state = initial_state(*scene);
  state.bodies[0].box = {20, 13.5, 8, 8};  // the floor under its right corner is at 22
  EXPECT_FALSE(solver.is_grounded(state, 1));
  state.bodies[0].box.y = 14;
  EXPECT_TRUE(solver.is_grounded(state, 1));
  state.bodies[0].box = {0, 16, 8, 8};
  EXPECT_TRUE(solver.is_grounded(state, 1));
  state.bodies[0].box.y = 15;
  EXPECT_FALSE(solver.is_grounded(state, 1));
  EXPECT_FALSE(solver.is_grounded(state, 2));
}

TEST(BumpSolver, AFallOntoASlopeBouncesByItsTrueNormal) {
  Level level = level_of({"..", "..", "..", "/-"});
  SharedTuning& t = level.tuning.shared;
  t.slope_width = t.slope_height = 8;
  t.fall_blend = t.drift_blend = 0;
  t.slope_bounce = 1;
  level.tuning.solver = SolverKind::bump;
  add_ball(level, {-4, 8}, {0, 5});
  const auto scene = scene_of(level);
  State state = initial_state(*scene);
  BumpSolver solver(scene);
  StepRecord record;
  for (int i = 0; i < 4 && state.bodies[0].velocity.y == 5; ++i) solver.step(state, {}, &record);
  EXPECT_NEAR(state.bodies[0].velocity.x, -5, 1e-14);
  EXPECT_NEAR(state.bodies[0].velocity.y, 0, 1e-14);
  ASSERT_EQ(record.contacts.size(), 1u);
  EXPECT_TRUE(record.contacts[0].handled);
  EXPECT_NEAR(record.contacts[0].normal.x, -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(record.contacts[0].normal.y, -std::sqrt(0.5), 1e-15);
}

TEST(BumpSolver, ASlopeStopsFromBelowAndBehindAsItsBox) {
  Level level = level_of({"......",  //
                          "./-...",  //
                          "......",  //
                          "......"});
  level.tuning.solver = SolverKind::bump;
  level.tuning.shared.fall_blend = level.tuning.shared.drift_blend = 0;
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0;
  add_ball(level, {10, 20}, {0, -6});
  add_ball(level, {28, 9}, {-6, 0});
  const Scene scene = compile_scene(level);
  const State state = step(scene, initial_state(scene), {});
  EXPECT_EQ(state.bodies[0].box.y, 16);
  EXPECT_EQ(state.bodies[1].box.x, 24);
}

TEST(BumpSolver, ABallOnFlatGroundMovesAsInTheArticle) {
  Level level = level_of({"#......#",  //
                          "#o.....#",  //
                          "#......#",  //
                          "########"});
  add_ball(level, {30, 3}, {3, -1});
  const Scene article = compile_scene(level);
  level.tuning.solver = SolverKind::bump;
  const Scene bump = compile_scene(level);
  State a = initial_state(article), b = initial_state(bump);
  for (int i = 0; i < 300; ++i) {
    a = step(article, a, {});
    b = step(bump, b, {});
    ASSERT_EQ(a, b) << "frame " << i;
  }
}

Level many_balls() {
  Level level = level_of({"##########",   //
                          "#o.o..o.o#",   //
                          "#........#",   //
                          "#../-\\-..#",  //
                          "##########"});
  level.tuning.solver = SolverKind::bump;
  return level;
}

TEST(BumpSolver, RecordingChangesNothing) {
  const auto scene = scene_of(many_balls());
  BumpSolver solver(scene), recording(scene);
  State state = initial_state(*scene), recorded = state;
  StepRecord record;
  for (int i = 0; i < 600; ++i) {
    solver.step(state, {}, nullptr);
    recording.step(recorded, {}, &record);
    ASSERT_EQ(state, recorded) << "frame " << i;
  }
}

TEST(BumpSolver, IsAFunctionOfItsArguments) {
  const auto scene = scene_of(many_balls());
  BumpSolver solver(scene);
  std::vector<State> states = {initial_state(*scene)};
  for (int i = 0; i < 200; ++i) {
    states.push_back(states.back());
    solver.step(states.back(), {}, nullptr);
  }
  for (std::size_t i = 199; i >= 7; i -= 7) {
    State again = states[i];
    solver.step(again, {}, nullptr);
    ASSERT_EQ(again, states[i + 1]) << "frame " << i;
    ASSERT_EQ(step(*scene, states[i], {}), states[i + 1]) << "frame " << i;
  }
}

TEST(BumpSolver, ADraggedBallStaysOnTheSlope) {
  const auto scene = scene_of(walking(hill(), 0));
  BumpSolver solver(scene);
  State state = initial_state(*scene);
  solver.step(state, {{4, 20}, true}, nullptr);
  ASSERT_EQ(state.grabbed, 1);
  for (int i = 0; i < 60; ++i) {
    solver.step(state, {{60, 20}, true}, nullptr);
    EXPECT_LE(state.bodies[0].box.bottom(), floor_under(state.bodies[0].box.x) + 1e-9) << "frame " << i;
  }
  EXPECT_GT(state.bodies[0].box.x, 24);
}

// Pinned: the same on every compiler and at every level of optimisation.
TEST(BumpSolver, EndsWithThePinnedHash) {
  Level level = load_level(source_path("tests/golden/article/six.lua")).value().level;
  level.tuning.solver = SolverKind::bump;
  const Scene scene = compile_scene(level);
  const auto solver = make_solver(std::make_shared<const Scene>(scene));
  State state = initial_state(scene);
  for (int i = 0; i < 600; ++i) solver->step(state, {});
  EXPECT_EQ(state_hash(state), 11587194158170007023u);
}

// A ball that flies straight, in a room whose ground is one tile shape in the cells of row 3.
Level room(TileShape shape, Vec2 position, Vec2 velocity) {
  Level level = walking(level_of({"......", "......", "......", "......", "......", "......"}), velocity.x);
  level.tuning.shared.fall_speed = velocity.y;
  level.tuning.shared.fall_blend = 1;
  for (int x = 0; x < 6; x += shape.tiles) level.map.set({x, 3}, 7);
  level.tile_shapes[7] = std::move(shape);
  add_ball(level, position, velocity);
  return level;
}

Rect after(const Level& level, int frames) {
  const auto scene = scene_of(level);
  BumpSolver solver(scene);
  State state = initial_state(*scene);
  for (int i = 0; i < frames; ++i) solver.step(state, {}, nullptr);
  return state.bodies[0].box;
}

TEST(BumpSolver, OneWayGroundStopsBodiesFromAboveOnly) {
  const TileShape platform{.kind = TileShape::Kind::solid, .one_way = true};
  EXPECT_EQ(after(room(platform, {20, 4}, {0, 2}), 60).y, 16);
  EXPECT_LT(after(room(platform, {20, 40}, {0, -2}), 20).y, 8);
  const TileShape sloped{.kind = TileShape::Kind::slope, .one_way = true, .tiles = 6, .heights = {0, 6}};
  const Rect on = after(room(sloped, {16, 4}, {0, 2}), 12);  // it slides down to the left
  EXPECT_NEAR(on.bottom(), 32 - 6 * (on.x + 8) / 48, 1e-6) << "under its right corner";
  EXPECT_LT(after(room(sloped, {16, 40}, {0, -2}), 20).y, 8);
}

TEST(BumpSolver, CeilingsStopRisingBodies) {
  const TileShape ceiling{
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .tiles = 6, .heights = {2, 8}};
  const Rect box = after(room(ceiling, {16, 40}, {0, -2}), 3);
  EXPECT_GE(box.y, 24 + 2 + 6.0 * (box.x + 8) / 48 - 1e-9);
  EXPECT_LT(box.y, 40);
  EXPECT_GT(after(room(ceiling, {16, 40}, {0, -2}), 30).y, 24);
}

TEST(BumpSolver, ProfilesCarryABall) {
  const TileShape hills{.kind = TileShape::Kind::profile, .tiles = 2, .heights = {4, 6, 8, 6, 4}};
  const auto scene = scene_of(room(hills, {0, 12}, {0.5, 0.25}));
  BumpSolver solver(scene);
  State state = initial_state(*scene);
  for (int i = 0; i < 200 && state.bodies[0].box.x <= 30; ++i) {
    solver.step(state, {}, nullptr);
    ASSERT_LE(state.bodies[0].box.bottom(), 28 + 1e-6) << "frame " << i << ": it fell through";
  }
  EXPECT_GT(state.bodies[0].box.x, 30) << "it got stuck";
}

// The article does not know such ground, and its motion stays the same.
TEST(BumpSolver, TheArticleIgnoresGroundThatItDoesNotKnow) {
  Level level = room({.kind = TileShape::Kind::solid, .one_way = true}, {20, 4}, {0, 2});
  EXPECT_EQ(scene_of(level)->items.size(), 7u);
  level.tuning.solver = SolverKind::article;
  EXPECT_EQ(scene_of(level)->items.size(), 1u);
}

}  // namespace talus::bump_solver_test
