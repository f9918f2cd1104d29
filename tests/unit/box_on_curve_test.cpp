// Boxes that meet others slide along curves with a corner.
#include <gtest/gtest.h>

#include <cmath>

#include <talus/level/body_kind.h>
#include "unit/meeting_run.h"

namespace talus::box_on_curve_test {

constexpr double kGravity = 0.1;  // px/frame^2

void add_curve(Level& level, decltype(Curve::form) form) {
  level.curves.push_back({"", {form, Curve::Faces::up}, ""});
}

// (px/frame)^2, of a unit of mass
double energy(const Body& body) { return dot(body.velocity, body.velocity) / 2 - kGravity * body.box.y; }

// A box of 8x8 px whose lower left corner is on an arc around 150, 100, so far from its lowest place;
// radians.
void add_on_bowl(Level& level, BodyKind kind, double radius, double angle) {
  add_body(level, kind, {150 - radius * std::sin(angle), 100 + radius * std::cos(angle) - 8});
}

TEST(BoxOnCurve, KeepsItsEnergyUntilItsOtherCornerHits) {
  for (const double radius : {60.0, 90.0}) {
    for (const int parts : {1, 3}) {
      Level level = open_level(kGravity, 0);
      level.tuning.exact.substeps = parts;
      add_curve(level, Arc{{150, 100}, radius, 150 - radius, 150 + radius, false});
      add_on_bowl(level, BodyKind::ball, radius, 0.9);
      MeetingRun run(level);
      const double before = energy(run.body(0));
      while (run.body(0).box.x < 140) {
        run.step();
        ASSERT_LT(run.state.frame, 100);
        const Vec2 corner{run.body(0).box.x - 150, run.body(0).box.bottom() - 100};
        ASSERT_NEAR(std::hypot(corner.x, corner.y), radius, 1e-9) << run.state.frame;
        ASSERT_NEAR(energy(run.body(0)), before, 1e-9) << run.state.frame;
      }
    }
  }
}

// Each time at the bottom the box runs onto its other corner, and loses what leads into the ground: it goes
// to and fro for a long time.
TEST(BoxOnCurve, DoesNotStickInABowl) {
  Level level = open_level(kGravity, 0);
  add_curve(level, Arc{{150, 100}, 60, 90, 210, false});
  for (const double angle : {1.0, 0.5, 0.1}) {
    level.spawns.clear();
    add_on_bowl(level, BodyKind::ball, 60, angle);
    MeetingRun run(level);
    StepRecord record;
    double right = 0;
    for (int frame = 0; frame < 300; ++frame) {
      run.solver->step(run.state, {}, &record);
      ASSERT_FALSE(record.paths[0].capped) << angle << ", " << frame;
      right = std::max(right, run.body(0).box.right());
    }
    EXPECT_GT(right, 150 + 60 * std::sin(angle) * 0.75) << "it comes up on the other side";
  }
}

// A body that slides off a circle without friction leaves it where the cosine is two thirds.
TEST(BoxOnCurve, LeavesAHillWhereItFliesOff) {
  Level level = open_level(kGravity, 0);
  constexpr double kRadius = 60, kAngle = 0.2;
  add_curve(level, Arc{{150, 160}, kRadius, 90, 210, true});
  add_body(level, BodyKind::ball,
           {150 - kRadius * std::sin(kAngle) - 8, 160 - kRadius * std::cos(kAngle) - 8});
  MeetingRun run(level);
  const double before = energy(run.body(0));
  // From rest at this angle, the cosine there is two thirds of that at the start.
  const double last = 2 * std::cos(kAngle) / 3;
  double left_at = 1;
  for (int frame = 0; frame < 200 && left_at == 1; ++frame) {
    run.step();
    const Vec2 corner{run.body(0).box.right() - 150, run.body(0).box.bottom() - 160};
    if (std::hypot(corner.x, corner.y) > kRadius + 1e-6) left_at = -corner.y / kRadius;
  }
  EXPECT_LT(left_at, last);
  EXPECT_GT(left_at, last - 0.06) << "within a frame";
  EXPECT_NEAR(energy(run.body(0)), before, 1e-4);
}

TEST(BoxOnCurve, GoesOnWhereHillsBecomeHollows) {
  Level level = open_level(kGravity, 0);
  add_curve(level, Sine{20, 440, 120, 6, 80, 20});
  add_body(level, BodyKind::ball, {38, 100}, {1.5, 0});
  MeetingRun run(level);
  StepRecord record;
  for (int frame = 0; frame < 120; ++frame) {
    run.solver->step(run.state, {}, &record);
    ASSERT_FALSE(record.paths[0].capped) << frame;
    ASSERT_GT(run.body(0).velocity.x, 0.2) << frame;
  }
  EXPECT_GT(run.body(0).box.x, 110);
}

TEST(BoxOnCurve, FrictionHoldsItOnAGentleSlope) {
  Level level = open_level(kGravity, 0);
  add_curve(level, Arc{{150, 100}, 60, 90, 210, false});
  add_on_bowl(level, BodyKind::crate, 60, 1.0);
  MeetingRun run(level);
  run.step(300);
  const Rect rests = run.body(0).box;
  EXPECT_EQ(run.body(0).velocity, Vec2());
  run.step(100);
  EXPECT_EQ(run.body(0).box, rests);
}

// What stands on a box that slides goes with it.
TEST(BoxOnCurve, CarriesOthers) {
  Level level = open_level(kGravity, 0);
  add_curve(level, Arc{{150, 100}, 90, 70, 230, false});
  add_on_bowl(level, BodyKind::crate, 90, 0.8);
  level.spawns.push_back(level.spawns[0]);
  level.spawns[1].position.y -= 8;
  MeetingRun run(level);
  StepRecord record;
  for (int frame = 0; frame < 60; ++frame) {
    run.solver->step(run.state, {}, &record);
    ASSERT_FALSE(record.paths[0].capped || record.paths[1].capped) << frame;
    const Rect lower = run.body(0).box, upper = run.body(1).box;
    ASSERT_NEAR(upper.bottom(), lower.y, 1.0 / 64) << frame;
  }
  EXPECT_GT(run.body(0).box.x, level.spawns[0].position.x + 10);
}

// The curve leads a little beside the path for which the wall was looked for.
TEST(BoxOnCurve, StopsAtAWall) {
  for (const int start : {0, 1, 2, 3, 4, 5, 6, 7}) {
    Level level = open_level(kGravity, 0);
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    for (int y = 14; y < 24; ++y) level.map.set({19, y}, 1);
    add_curve(level, Arc{{150, 100}, 60, 90, 210, false});
    add_on_bowl(level, BodyKind::ball, 60, 0.5 + 0.05 * start);
    MeetingRun run(level);
    for (int frame = 0; frame < 120; ++frame) {
      run.step();
      ASSERT_LE(run.body(0).box.right(), 152 + 1e-9) << frame;
    }
    EXPECT_NEAR(run.body(0).box.right(), 152, 1e-9);
  }
}

TEST(BoxOnCurve, AMirroredBowlRunsMirrored) {
  for (const BodyKind kind : {BodyKind::ball, BodyKind::crate}) {
    Level level = open_level(kGravity, 0.3);
    add_curve(level, Arc{{150, 100}, 60, 90, 210, false});
    add_on_bowl(level, kind, 60, 0.9);
    Level image = level;
    image.spawns[0].position.x = 300 - level.spawns[0].position.x - 8;
    MeetingRun run(level), mirrored(image);
    for (int frame = 0; frame < 300; ++frame) {
      run.step();
      mirrored.step();
      ASSERT_NEAR(run.body(0).box.x, 300 - mirrored.body(0).box.right(), 1e-9) << frame;
      ASSERT_NEAR(run.body(0).box.y, mirrored.body(0).box.y, 1e-9) << frame;
    }
  }
}

}  // namespace talus::box_on_curve_test
