// Conveyors: ground whose surface goes along it, and carries what rubs on it or walks on it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <talus/level/body_kind.h>
#include <talus/level/ground.h>
#include <talus/level/tile_turns.h>
#include "collision/ground_queries.h"
#include "level/transform.h"
#include "level_picture.h"
#include "meeting_run.h"
#include "reference/closed_forms.h"

namespace talus::conveyor_test {

constexpr double kGravity = 0.1, kFriction = 0.5;  // px/frame^2; of crates and discs

// A floor of full tiles from y = 24 on, which goes to the right at this speed.
Level belt(double speed) {
  Level level = meeting_level({"..............................", "..............................",
                               "..............................", "##############################"},
                              kGravity, 0);
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid, .conveyor = speed};
  return level;
}

// ---- Friction ----

TEST(Conveyor, CarriesACrateToTheClosedForm) {
  for (const double speed : {1.0, -1.5, 0.25}) {
    for (const double start : {0.0, -2.0, 2.5}) {
      Level level = belt(speed);
      add_body(level, BodyKind::crate, {100, 16}, {start, 0});
      MeetingRun run(level);
      const reference::Carried carried{start, speed, kFriction * kGravity};
      for (int frame = 1; frame <= 60; ++frame) {
        run.step();
        ASSERT_NEAR(run.body(0).box.x, 100 + carried.way(frame), 1e-11) << speed << " " << frame;
        ASSERT_EQ(run.body(0).box.y, 16) << frame;
      }
      if (carried.keeps_up_at() < 60) {
        EXPECT_NEAR(run.body(0).velocity.x, speed, 1e-12);
      }
    }
  }
}

TEST(Conveyor, CarriesACrateUpASlope) {
  for (const double slope : {0.25, 1.0}) {  // less and more than friction holds
    Level level = open_level(kGravity, 0);
    level.curves.push_back({"", {Segment{{16, 232}, {240, 232 - 224 * slope}}, Curve::Faces::up, 1.0}, ""});
    const double size = std::hypot(1, slope);
    add_body(level, BodyKind::crate, {140, 232 - 132 * slope - 8});
    MeetingRun run(level);
    const double pulls = kGravity * slope / size, rubs = kFriction * kGravity / size;
    // Where friction is too weak it slides down, against it.
    const reference::Carried up{0, 1, rubs - pulls};
    for (int frame = 1; frame <= 60; ++frame) {
      run.step();
      const double way = slope < kFriction ? up.way(frame) : (rubs - pulls) * frame * frame / 2;
      ASSERT_NEAR(run.body(0).box.x, 140 + way / size, 1e-9) << slope << " " << frame;
    }
  }
}

// Friction moves and turns it: it goes a third as fast as the conveyor, and rolls back on it.
TEST(Conveyor, RollsADisc) {
  Level level = belt(1.5);
  add_body(level, BodyKind::disc, {60, 16});
  MeetingRun run(level);
  const reference::Carried carried{0, 0.5, kFriction * kGravity};
  for (int frame = 1; frame <= 60; ++frame) {
    run.step();
    ASSERT_NEAR(run.body(0).box.x, 60 + carried.way(frame), 1e-11) << frame;
  }
  EXPECT_NEAR(run.body(0).velocity.x, 0.5, 1e-12);
  EXPECT_NEAR(run.body(0).spin, -1, 1e-12);
}

TEST(Conveyor, LetsACrateRestAtAWall) {
  Level level = belt(1);
  level.curves.push_back({"", {Segment{{150, 0}, {150, 24}}, Curve::Faces::up}, ""});
  add_body(level, BodyKind::crate, {130, 16});
  MeetingRun run(level);
  run.step(100);
  EXPECT_EQ(run.body(0).box.x, 142);
  const State before = run.state;
  run.step(100);
  EXPECT_EQ(run.body(0).box, before.bodies[0].box);
  EXPECT_EQ(run.body(0).velocity, Vec2());
}

// Stacked crates ride on the lowest one.
TEST(Conveyor, CarriesAStack) {
  Level level = belt(0.5);
  for (int i = 0; i < 3; ++i) add_body(level, BodyKind::crate, {100, 16.0 - 8 * i});
  MeetingRun run(level);
  run.step(100);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(run.body(i).velocity.x, 0.5, 1e-12) << i;
    EXPECT_NEAR(run.body(i).box.x, run.body(0).box.x, 1e-9) << i;
  }
}

TEST(Conveyor, CarriesMirrored) {
  Level level = belt(0.7);
  level.curves.push_back({"", {Segment{{60, 24}, {120, 4}}, Curve::Faces::up, -0.4}, ""});
  add_body(level, BodyKind::crate, {90, 0});
  add_body(level, BodyKind::disc, {190, 10}, {1, 0});
  add_body(level, BodyKind::crate, {150, 10}, {-1, 0}, {12, 10});
  MeetingRun run(level), image(mirrored(level));
  for (int frame = 0; frame < 120; ++frame) {
    run.step();
    image.step();
    for (std::size_t i = 0; i < 3; ++i) {
      const Body &body = run.body(i), &other = image.body(i);
      ASSERT_NEAR(body.box.x, level.map.px_width() - other.box.right(), 1e-9) << frame << " " << i;
      ASSERT_NEAR(body.spin, -other.spin, 1e-9) << frame << " " << i;
    }
  }
}

// ---- Which conveyor ----

TEST(Conveyor, OfTilesSideBySideIsThatUnderTheMiddle) {
  Level level = belt(1);
  level.tile_shapes[40] = {.kind = TileShape::Kind::solid, .conveyor = -0.5};
  level.map.set({10, 3}, 40);
  const Terrain ground = terrain_of(level);
  const auto under = [&](double x, double w) {
    const Rect box{x, 8, w, 16};
    const auto contact = cast_box<double>(ground, {box, {0, 1}});
    return conveyor_at(ground, contact, box);
  };
  EXPECT_EQ(under(40, 8), 1);
  EXPECT_EQ(under(80, 8), -0.5);
  EXPECT_EQ(under(73, 16), -0.5);
  EXPECT_EQ(under(71, 16), 1);
  EXPECT_EQ(under(72, 16), 0.25) << "half on each";
}

TEST(Conveyor, GoesClockwiseAroundTheGround) {
  Level level = open_level(0, 0);
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid, .conveyor = 1};
  level.map.set({10, 10}, 1);
  const Terrain ground = terrain_of(level);
  for (const Vec2 way : {Vec2{0, 8}, Vec2{0, -8}, Vec2{8, 0}, Vec2{-8, 0}}) {
    const Rect box{80 - way.x * 1.5, 80 - way.y * 1.5, 8, 8};
    const auto contact = cast_box<double>(ground, {box, way});
    ASSERT_TRUE(contact);
    EXPECT_EQ(conveyor_at(ground, contact, {contact.position.x, contact.position.y, 8, 8}), 1);
  }
}

TEST(Conveyor, OfATurnedTileIsTurnedWithIt) {
  const TileShape solid{.kind = TileShape::Kind::solid, .conveyor = 1.5};
  const auto speed = [&](bool diagonal, bool left_right, bool up_down) {
    return turned(solid, turn_of(diagonal, left_right, up_down), {8, 8}).conveyor;
  };
  EXPECT_EQ(speed(false, true, false), -1.5);
  EXPECT_EQ(speed(false, false, true), -1.5);
  EXPECT_EQ(speed(false, true, true), 1.5);
  EXPECT_EQ(speed(true, true, false), 1.5) << "a quarter to the right";
}

// ---- Players ----

// Its speed tends to that of the floor and of its run.
TEST(Conveyor, CarriesAPlayerWhoWalksOrStands) {
  for (const double speed : {0.5, -0.75}) {
    for (const int direction : {-1, 0, 1}) {
      Level level = belt(speed);
      add_body(level, BodyKind::player, {100, 16});
      MeetingRun run(level);
      run.step(2);
      const PlayerTuning& t = level.tuning.player;
      double v = run.body(0).velocity.x, x = run.body(0).box.x;
      Input input;
      input.left = direction < 0;
      input.right = direction > 0;
      const double goal = speed + t.run_speed * direction;
      for (int frame = 0; frame < 30; ++frame) {
        const double gain = direction == 0 ? t.run_loss : t.run_gain;
        v = v < goal ? std::min(v + gain, goal) : std::max(v - gain, goal);
        x += v;
        run.step(1, input);
        ASSERT_NEAR(run.body(0).box.x, x, 1e-10) << speed << " " << direction << " " << frame;
        ASSERT_TRUE(run.body(0).gait.grounded);
      }
    }
  }
}

TEST(Conveyor, LeavesItsSpeedToAPlayerWhoJumps) {
  Level level = belt(1);
  add_body(level, BodyKind::player, {100, 16});
  MeetingRun run(level);
  run.step(20);
  ASSERT_EQ(run.body(0).velocity.x, 1);
  Input jump;
  jump.jump = true;
  run.step(1, jump);
  EXPECT_EQ(run.body(0).velocity.x, 1);
  run.step(1, jump);
  EXPECT_LT(run.body(0).velocity.x, 1) << "the air slows it like any jump";
}

// ---- Limits ----

TEST(Conveyor, HasASpeedWithinLimits) {
  const auto problem = [](double speed) {
    return problem_of(TileShape{.kind = TileShape::Kind::solid, .conveyor = speed}, {8, 8}).value_or("");
  };
  EXPECT_EQ(problem(64), "");
  EXPECT_EQ(problem(-65), "has a conveyor that is faster than 64 px a frame");
  EXPECT_EQ(problem(std::nan("")), "has a conveyor whose speed is not a number");
  Curve curve{Segment{{0, 0}, {8, 0}}, Curve::Faces::up, 1e9};
  EXPECT_EQ(problem_of(curve), "has a conveyor that is faster than 64 px a frame");
}

}  // namespace talus::conveyor_test
