// Balls that meet two sides of the ground at one time: the answer does not depend on which rounding calls the
// first. So a mirrored level runs mirrored.
#include "sim/ball_side.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "level/transform.h"
#include "meeting_run.h"

namespace talus::ball_side_test {

using Side = BallSide<double>;

constexpr Side kRises{{-0.6, -0.8}, 0.5, 0.9}, kFalls{{0.6, -0.8}, 0.5, 0.9},
    kSteep{{-0.96, -0.28}, 0.5, 0.9};

Vec2 after(Vec2 velocity, Side side, Side beside) {
  std::optional<Side> other = beside;
  keep_what_stops(velocity, side, other);
  return other ? reflect_between(velocity, side, *other) : side.reflect(velocity);
}

TEST(BallSide, TwoThatStopItSendItBack) {
  EXPECT_EQ(after({0, 2}, kRises, kFalls), (Vec2{0, -1}));
  EXPECT_EQ(after({0, 2}, kFalls, kRises), (Vec2{0, -1}));
}

TEST(BallSide, OneThatStopsItIsTheOnlyOne) {
  for (const Vec2 velocity : {Vec2{2, 0.5}, {3, -1}}) {
    EXPECT_EQ(after(velocity, kRises, kSteep), after(velocity, kSteep, kRises)) << velocity.x;
    EXPECT_EQ(after(velocity, kRises, kSteep), kSteep.reflect(velocity)) << velocity.x;
  }
  EXPECT_EQ(after({0, 2}, kRises, kSteep), kRises.reflect({0, 2}));
}

TEST(BallSide, PiecesOfACurveAreOne) {
  const Side next{{-0.6 - 1e-9, -0.8 + 1e-9}, 0.5, 0.9};
  EXPECT_EQ(after({0, 2}, kRises, next), kRises.reflect({0, 2}));
}

// A room with hills of straight lines, between whole pixels; a ball falls on them.
Level hilly_level(std::uint32_t seed, double gravity, double bounce, bool rebound) {
  const auto up_to = [&](int last) {
    seed = seed * 1664525 + 1013904223;
    return static_cast<int>(seed >> 16) % (last + 1);
  };
  Level level = room_level(40, 24, gravity);
  level.tuning.shared = {};
  level.tuning.shared.drift_speed = 0;
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = bounce;
  level.tuning.exact.rebound = rebound;
  for (Vec2 from{8, 120}; from.x < 312;) {
    const double x = from.x + up_to(40) + 8;
    const Vec2 to{x < 304 ? x : 312, std::clamp(from.y + up_to(60) - 30.0, 60.0, 176.0)};
    level.curves.push_back({"", {Segment{from, to}, Curve::Faces::up}, ""});
    from = to;
  }
  const double x = up_to(280) + 12;
  add_body(level, BodyKind::ball, {x, 20}, {up_to(24) / 4.0 - 3, 0}, {up_to(6) + 5.0, up_to(6) + 5.0});
  return level;
}

// px: how far apart a level and its mirror image are after at most 1,200 frames.
double apart(const Level& level) {
  MeetingRun run(level), mirror(mirrored(level));
  double most = 0;
  for (int frame = 0; frame < 1200; ++frame) {
    run.step();
    mirror.step();
    const Rect a = run.body(0).box, b = mirror.body(0).box;
    most = std::max({most, std::abs(a.x - (level.map.px_width() - b.right())), std::abs(a.y - b.y)});
  }
  return most;
}

TEST(BallOnHills, RunsMirroredInAMirroredLevel) {
  // The first 13 parted while rounding chose what a ball meets first.
  for (const std::uint32_t seed : {264,  461, 474, 499, 588, 712, 896, 975, 1065, 1148, 1164, 1373,
                                   1396, 1,   2,   3,   4,   5,   6,   7,   8,    9,    10,   11}) {
    for (const double gravity : {0.0, 0.2}) {
      for (const bool rebound : {false, true})
        EXPECT_LT(apart(hilly_level(seed, gravity, 0.5, rebound)), 1e-9)
            << "seed " << seed << ", gravity " << gravity << ", rebound " << rebound;
    }
  }
}

TEST(BallOnHills, GoesBackFromTheBottomOfAV) {
  for (const double gravity : {0.0, 0.2}) {
    Level level = room_level(20, 20, gravity);
    level.tuning.shared = {};
    level.tuning.shared.fall_blend = level.tuning.shared.drift_blend = 0;
    level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0.5;
    level.tuning.exact.rebound = 1;
    level.curves.push_back({"", {Segment{{18, 95}, {78, 140}}, Curve::Faces::up}, ""});
    level.curves.push_back({"", {Segment{{78, 140}, {138, 125}}, Curve::Faces::up}, ""});
    add_body(level, BodyKind::ball, {76, 100}, {0, 4});
    MeetingRun run(level);
    const double speed = std::sqrt(16 + 2 * gravity * 30.5);
    while (run.body(0).velocity.y > 0) run.step();
    EXPECT_EQ(run.body(0).box.x, 76) << gravity;
    EXPECT_NEAR(run.body(0).velocity.y, -speed / 2, gravity + 1e-9) << gravity;
  }
}

}  // namespace talus::ball_side_test
