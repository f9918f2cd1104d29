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
#include "property/random_ground.h"
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

// The shapes whose top is level, at the same height for each of them.
std::vector<TileShape> level_shapes() {
  using Kind = TileShape::Kind;
  return {{.kind = Kind::solid},
          {.kind = Kind::solid, .one_way = true},
          {.kind = Kind::slope, .heights = {8, 8}},
          {.kind = Kind::polygon, .points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}}},
          {.kind = Kind::group, .parts = {{.kind = Kind::slope, .heights = {8, 8}}, {.kind = Kind::solid}}}};
}

TileShape with_speed(TileShape shape, double speed) {
  shape.conveyor = speed;
  return shape;
}

// A floor that goes at one speed up to x = 80, and at another one from there on.
Level joint(const TileShape& left, const TileShape& right, double left_speed, double right_speed) {
  Level level = belt(0);
  level.tile_shapes[40] = with_speed(left, left_speed);
  level.tile_shapes[41] = with_speed(right, right_speed);
  for (int x = 0; x < level.map.width(); ++x) level.map.set({x, 3}, x < 10 ? 40 : 41);
  return level;
}

// The speed that a box gets that comes down, or goes this way, to the ground.
double speed_at(const Terrain& ground, const Rect& box, Vec2 way = {0, 8}) {
  const auto contact = cast_box<double>(ground, {box, way});
  EXPECT_TRUE(contact);
  return conveyor_at(ground, contact, {contact.position.x, contact.position.y, box.w, box.h});
}

TEST(Conveyor, OfGroundSideBySideIsTheMean) {
  for (const TileShape& left : level_shapes()) {
    for (const TileShape& right : level_shapes()) {
      const Terrain ground = terrain_of(joint(left, right, 1, -0.5));
      const auto under = [&](double x, double w) { return speed_at(ground, {x, 6, w, 16}); };
      EXPECT_EQ(under(40, 8), 1);
      EXPECT_EQ(under(60, 20), 1);
      EXPECT_EQ(under(80, 8), -0.5);
      EXPECT_EQ(under(73, 8), 1 - 1.5 / 8);
      EXPECT_EQ(under(68, 16), 1 - 1.5 / 4);
      EXPECT_EQ(under(72, 16), 0.25) << "half on each";
      EXPECT_EQ(under(80, 0), 0.25) << "without a width";
    }
  }
}

TEST(Conveyor, IsNoneOnGroundThatStandsStill) {
  const TileShape solid{.kind = TileShape::Kind::solid},
      half{.kind = TileShape::Kind::slope, .heights = {4, 4}};
  EXPECT_EQ(speed_at(terrain_of(joint(solid, solid, 0, 2)), {74, 8, 8, 8}), 0.5);
  EXPECT_EQ(speed_at(terrain_of(joint(half, half, 0, 2)), {74, 8, 8, 8}, {0, 16}), 0.5);
  EXPECT_EQ(speed_at(terrain_of(joint(solid, half, 0, 2)), {74, 8, 8, 8}), 0) << "4 px below";
  EXPECT_EQ(speed_at(terrain_of(joint(solid, half, 3, 0)), {74, 8, 8, 8}), 3) << "air is no ground";
}

TEST(Conveyor, OfCurvesAndTilesIsTheMean) {
  Level level = belt(1);
  for (int x = 10; x < 20; ++x) level.map.set({x, 3}, 0);
  level.curves.push_back({"", {Segment{{80, 24}, {110, 24}}, Curve::Faces::up, -1.0}, ""});
  level.curves.push_back({"", {Segment{{110, 24}, {160, 24}}, Curve::Faces::both, 0.0}, ""});
  const Terrain ground = terrain_of(level);
  EXPECT_EQ(speed_at(ground, {72, 8, 16, 10}), 0);
  EXPECT_EQ(speed_at(ground, {78, 8, 8, 10}), -0.5);
  EXPECT_EQ(speed_at(ground, {90, 8, 8, 10}), -1);
  EXPECT_EQ(speed_at(ground, {108, 8, 8, 10}), -0.25);
}

// A box may lie on the peak between two slopes, and on level ground as high.
TEST(Conveyor, OfAPeakIsThatOfBothSides) {
  const TileShape up{.kind = TileShape::Kind::slope, .heights = {0, 8}};
  Level level = joint(up, {.kind = TileShape::Kind::slope, .heights = {8, 0}}, 2, -1);
  for (int x = 0; x < 30; ++x)
    if (x != 9 && x != 10) level.map.set({x, 3}, 0);
  EXPECT_EQ(speed_at(terrain_of(level), {75, 8, 8, 10}), 0.5);
  level.tile_shapes[42] = {.kind = TileShape::Kind::solid, .conveyor = 3};
  level.map.set({10, 3}, 42);
  EXPECT_EQ(speed_at(terrain_of(level), {74, 8, 8, 10}), 3) << "the peak has no length";
}

TEST(Conveyor, OfWallsIsTheMean) {
  for (const TileShape& shape : level_shapes()) {
    if (shape.one_way) continue;
    Level level = open_level(0, 0);
    level.tile_shapes[40] = with_speed(shape, 1);
    level.tile_shapes[41] = with_speed(shape, -1);
    for (int y = 5; y < 15; ++y) level.map.set({10, y}, y < 10 ? 40 : 41);
    const Terrain ground = terrain_of(level);
    for (const auto& [x, way] : {std::pair{66.0, 16.0}, std::pair{94.0, -16.0}}) {
      EXPECT_EQ(speed_at(ground, {x, 60, 8, 8}, {way, 0}), 1);
      EXPECT_EQ(speed_at(ground, {x, 74, 8, 8}, {way, 0}), 0.5);
      EXPECT_EQ(speed_at(ground, {x, 76, 8, 8}, {way, 0}), 0);
      EXPECT_EQ(speed_at(ground, {x, 90, 8, 8}, {way, 0}), -1);
    }
  }
}

// A crate slows down over the joint, and so does a player; where the mean is 0, they stay.
TEST(Conveyor, LetsThemRestBetweenTwoThatMeet) {
  for (const BodyKind kind : {BodyKind::crate, BodyKind::player}) {
    for (const TileShape& shape : level_shapes()) {
      Level level = joint(shape, shape, 1, -1);
      add_body(level, kind, {60, 16});
      MeetingRun run(level);
      run.step(300);
      EXPECT_NEAR(run.body(0).box.x, 76, 1e-9);
      EXPECT_NEAR(run.body(0).velocity.x, 0, 1e-9);
    }
  }
}

// A crate never stops on the way off a conveyor, though this slows down under it.
TEST(Conveyor, CarriesACrateSmoothlyOffItsEnd) {
  Level level = joint(level_shapes()[0], level_shapes()[2], 1, 0);
  add_body(level, BodyKind::crate, {79.4, 16});
  MeetingRun run(level);
  for (int frame = 0; frame < 30; ++frame) {
    run.step();
    const Body& body = run.body(0);
    ASSERT_GT(body.velocity.x, 0) << frame;
    ASSERT_LT(body.velocity.x, 0.6 / 8) << frame;
    ASSERT_LT(body.box.x, 80) << frame;
  }
  EXPECT_GT(run.body(0).box.x, 79.9);
}

// A disc touches one point of the ground. It swings over a joint, and no further with time.
TEST(Conveyor, LetsADiscSwingBetweenTwoThatMeet) {
  Level level = joint(level_shapes()[0], level_shapes()[2], 1, -1);
  add_body(level, BodyKind::disc, {60, 16});
  MeetingRun run(level);
  run.step(200);
  for (int frame = 0; frame < 800; ++frame) {
    run.step();
    ASSERT_NEAR(run.body(0).box.x, 76, 1.5) << frame;
  }
}

TEST(Conveyor, CarriesMirroredOverJoints) {
  const std::vector<TileShape> shapes = level_shapes();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Dice dice(seed);
    Level level = belt(0);
    for (int x = 0; x < level.map.width(); ++x) {
      const auto tile = static_cast<TileNumber>(40 + x);
      level.tile_shapes[tile] = with_speed(shapes[static_cast<std::size_t>(dice.up_to(4))], dice.in(-2, 2));
      level.map.set({x, 3}, tile);
    }
    add_body(level, seed % 2 == 0 ? BodyKind::crate : BodyKind::disc, {dice.step(60, 160, 1), 10},
             {dice.in(-1, 1), 0});
    MeetingRun run(level), image(mirrored(level));
    for (int frame = 0; frame < 120; ++frame) {
      run.step();
      image.step();
      const Body &body = run.body(0), &other = image.body(0);
      ASSERT_NEAR(body.box.x, level.map.px_width() - other.box.right(), 1e-9) << seed << " " << frame;
      ASSERT_NEAR(body.spin, -other.spin, 1e-9) << seed << " " << frame;
    }
  }
}

TEST(Conveyor, OfLayersIsThatOfTheOneInFront) {
  const TileShape solid{.kind = TileShape::Kind::solid},
      half{.kind = TileShape::Kind::slope, .heights = {4, 4}};
  const auto speed = [](const TileShape& behind, const TileShape& in_front) {
    Level level = belt(0);
    level.tile_shapes[1] = behind;
    level.tile_shapes[40] = in_front;
    TileLayer front;
    MapCells cells(level.map.cells().size());
    for (std::size_t x = 0; x < 30; ++x) cells.set(90 + x, 40);
    front.cells = std::make_shared<const MapCells>(cells);
    level.layers.list.push_back(front);
    return speed_at(terrain_of(level), {40, 6, 8, 10}, {0, 16});
  };
  EXPECT_EQ(speed(with_speed(solid, 1), with_speed(solid, -1)), -1);
  EXPECT_EQ(speed(with_speed(solid, 1), solid), 0) << "what is hidden moves nothing";
  EXPECT_EQ(speed(solid, with_speed(solid, 1)), 1);
  EXPECT_EQ(speed(with_speed(solid, 1), half), 0) << "though the one behind is higher";
  EXPECT_EQ(speed(with_speed(half, 1), with_speed(solid, 2)), 2);
  EXPECT_EQ(speed(with_speed(solid, 1), {}), 1) << "air is no ground";
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
