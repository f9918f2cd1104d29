// The article solver beyond its golden trajectories: what it records, and that equal arguments give equal
// results.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <talus/formats/format.h>
#include <talus/sim/solver.h>
#include "level_picture.h"
#include "paths.h"

namespace talus::article_solver_test {

std::shared_ptr<const Scene> scene_of(const Level& level) {
  return std::make_shared<const Scene>(compile_scene(level));
}

// A ball over the left half of an up-slope, with a wall on each side.
Level ball_over_slope() {
  return level_of({"#....#",  //
                   "#o...#",  //
                   "#/-###",  //
                   "######"});
}

TEST(ArticleSolver, GravityIsTheArticlesLerp) {
  const Scene scene = compile_scene(level_of({"o", ".", "."}));
  const State state = step(scene, initial_state(scene), {});
  EXPECT_EQ(state.frame, 1);
  EXPECT_EQ(state.bodies[0].velocity.y, ((1 - 0.075) * 0) + (0.075 * 5));
  EXPECT_EQ(state.bodies[0].box.y, 0.375);
}

TEST(ArticleSolver, RecordsTheSlopesDeltaAndFloor) {
  const auto scene = scene_of(ball_over_slope());
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  StepRecord record;
  int corrected = 0;
  for (int i = 0; i < 60; ++i) {
    solver->step(state, {}, &record);
    for (const ContactRecord& contact : record.contacts) {
      if (!contact.slope) continue;
      EXPECT_EQ(contact.other.cell, (Cell{1, 2}));
      EXPECT_EQ(contact.slope->slope.box, (Rect{8, 16, 16, 8}));
      // The box spans x = 8..24 and rises from y = 24 to 16: the floor at the centre, and the box put on it.
      EXPECT_EQ(contact.slope->floor_y, 24 - 8 * contact.slope->delta);
      EXPECT_EQ(contact.slope->placed_y, std::floor(contact.slope->floor_y - 8));
      EXPECT_LT(contact.slope->normal.x, 0);
      EXPECT_LT(contact.slope->normal.y, 0);
      corrected += contact.slope->corrected;
    }
  }
  EXPECT_GT(corrected, 0);
}

TEST(ArticleSolver, RecordsThePathOfEachBodyAndTheTestedBoxes) {
  const auto scene = scene_of(level_of({"o.o",  //
                                        "###"}));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  StepRecord record;
  solver->step(state, {}, &record);
  ASSERT_EQ(record.paths.size(), 2u);
  EXPECT_EQ(record.paths[1].body, 2);
  EXPECT_EQ(record.paths[1].from, (Rect{16, 0, 8, 8}));
  EXPECT_EQ(record.paths[1].goal, (Vec2{16, 0.375}));
  EXPECT_EQ(record.paths[1].to, (Rect{16, 0, 8, 8}));
  ASSERT_EQ(record.contacts.size(), 2u);
  EXPECT_EQ(record.contacts[0].normal, (Vec2{0, -1}));
  EXPECT_TRUE(record.contacts[0].handled);
  // One grid cell holds everything: three tiles and the other ball, each listed once.
  for (const int body : {1, 2}) {
    EXPECT_EQ(std::count_if(record.tested.begin(), record.tested.end(),
                            [&](const TestedBox& box) { return box.body == body; }),
              4);
  }
}

TEST(ArticleSolver, BallsCollideUnlessTheTuningTurnsItOff) {
  Level level = level_of({"o",  //
                          "o",  //
                          "#"});
  Scene scene = compile_scene(level);
  State state = initial_state(scene);
  for (int i = 0; i < 30; ++i) state = step(scene, state, {});
  EXPECT_EQ(state.bodies[0].box.y, 0);

  level.tuning.shared.bodies = 0;
  scene = compile_scene(level);
  state = initial_state(scene);
  for (int i = 0; i < 120; ++i) state = step(scene, state, {});
  EXPECT_GT(state.bodies[0].box.y, 4);
}

TEST(ArticleSolver, TheMouseGrabsDragsAndThrowsABall) {
  const Scene scene = compile_scene(level_of({"o.....", "......", "......"}));
  State state = initial_state(scene);
  state = step(scene, state, {{100, 100}, true});
  EXPECT_EQ(state.grabbed, 0);  // pressed beside the ball
  state = initial_state(scene);
  state = step(scene, state, {{4, 4}, true});
  EXPECT_EQ(state.grabbed, 1);
  EXPECT_EQ(state.bodies[0].box.x, 0);
  state = step(scene, state, {{14, 4}, true});
  EXPECT_EQ(state.bodies[0].box.x, ((1 - 0.3) * 0) + (0.3 * (14 - 4)));
  const double thrown = state.bodies[0].box.x - 0;
  state = step(scene, state, {{14, 4}, false});
  EXPECT_EQ(state.grabbed, 0);
  EXPECT_EQ(state.bodies[0].velocity.x, ((1 - 0.03) * thrown) + (0.03 * 0));
}

TEST(ArticleSolver, AnyNumberCanBeTuned) {
  Level level = level_of({"o", ".", "."});
  level.tuning.shared.fall_speed = 2;
  level.tuning.shared.fall_blend = 0.5;
  const Scene scene = compile_scene(level);
  EXPECT_EQ(step(scene, initial_state(scene), {}).bodies[0].velocity.y, 1);
}

// Every number of the tuning is set to both ends of its range: nothing overflows, and a limit that is reached
// is reported.
TEST(ArticleSolver, TuningAtEitherEndOfItsRangeIsSafe) {
  const Level level = level_of({"#######",  //
                                "#o.o.o#",  //
                                "#./-..#",  //
                                "#######"});
  bool limited = false;
  for (const TuningField& field : tuning_fields()) {
    for (const double value : {field.min, field.max}) {
      Level tuned = level;
      field.in(tuned.tuning) = value;
      const auto scene = scene_of(tuned);
      const auto solver = make_solver(scene);
      State state = initial_state(*scene);
      StepRecord record;
      for (int i = 0; i < 3000; ++i) {
        solver->step(state, {}, &record);
        for (const BodyPath& path : record.paths) limited |= path.limited;
      }
      for (const Body& body : state.bodies) {
        EXPECT_LE(std::abs(body.velocity.x), kMaxBodySpeed) << field.key << " " << value;
        EXPECT_LE(std::abs(body.box.y), kMaxBodyDistance) << field.key << " " << value;
      }
    }
  }
  EXPECT_TRUE(limited);
}

class SixBalls : public testing::Test {
 protected:
  SixBalls() {
    auto loaded = load_level(source_path("tests/golden/article/six.lua"));
    loaded.value().level.tuning.solver = SolverKind::article;
    scene_ = scene_of(loaded.value().level);
  }
  State run(int frames, StepRecord* record) {
    const auto solver = make_solver(scene_);
    State state = initial_state(*scene_);
    for (int i = 0; i < frames; ++i) solver->step(state, {}, record);
    return state;
  }
  std::shared_ptr<const Scene> scene_;
};

// Pinned: the same on every compiler and at every level of optimisation.
TEST_F(SixBalls, EndWithThePinnedHash) { EXPECT_EQ(state_hash(run(600, nullptr)), 13806910258337872463u); }

TEST_F(SixBalls, RecordingChangesNothing) {
  StepRecord record;
  EXPECT_EQ(run(600, &record), run(600, nullptr));
}

TEST_F(SixBalls, ASolverIsAFunctionOfItsArguments) {
  const auto solver = make_solver(scene_);
  std::vector<State> states = {initial_state(*scene_)};
  for (int i = 0; i < 200; ++i) {
    State next = states.back();
    solver->step(next, {});
    states.push_back(next);
  }
  // The same solver runs backwards, and is compared with a fresh one.
  for (std::size_t i = 199; i >= 7; i -= 7) {
    State again = states[i];
    solver->step(again, {});
    ASSERT_EQ(again, states[i + 1]) << "frame " << i;
    ASSERT_EQ(step(*scene_, states[i], {}), states[i + 1]) << "frame " << i;
  }
}

}  // namespace talus::article_solver_test
