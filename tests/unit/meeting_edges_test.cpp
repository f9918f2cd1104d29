// Bodies that meet, where the ground ends or begins: nothing stops them that is not there, and nothing lets
// them in. `talus prove` has found each of these.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <talus/level/body_kind.h>
#include "unit/meeting_run.h"

namespace talus::meeting_edges_test {

constexpr double kGravity = 0.2;  // px/frame^2

void put(Level& level, Cell cell, const TileShape& shape) {
  const auto unused = std::find_if(level.tile_shapes.begin() + 1, level.tile_shapes.end(),
                                   [](const auto& s) { return s.kind == TileShape::Kind::none; });
  *unused = shape;
  level.map.set(cell, static_cast<TileNumber>(unused - level.tile_shapes.begin()));
}
TileShape solid(bool one_way = false) {
  return {.kind = TileShape::Kind::solid, .side = TileShape::Side::floor, .one_way = one_way};
}
TileShape slope(double left, double right) {
  return {.kind = TileShape::Kind::slope, .heights = {left, right}};
}

// The chord of the frame meets the floor a little before its end, and the parabola passes above that.
TEST(MeetingEdges, AFlightPastTheEndOfAFloorHitsNothing) {
  for (const int parts : {1, 2}) {
    Level level = open_level(kGravity, 1);
    level.tuning.exact.substeps = parts;
    put(level, {18, 10}, solid());
    // Its left side is over the end, at 152, after 0.8 frames: it is 0.002 px above the floor then.
    const double fallen = 2 * 0.8 + kGravity * 0.8 * 0.8 / 2;
    add_body(level, BodyKind::ball, {152 - 2 * 0.8, 80 - 8 - fallen - 0.002}, {2, 2});
    MeetingRun run(level);
    StepRecord record;
    run.solver->step(run.state, {}, &record);
    EXPECT_TRUE(record.contacts.empty()) << parts;
    EXPECT_EQ(run.body(0).velocity.y, 2 + kGravity) << parts;
  }
}

TEST(MeetingEdges, AFlightThatReachesTheFloorBounces) {
  Level level = open_level(kGravity, 1);
  put(level, {18, 10}, solid());
  const double fallen = 2 * 0.8 + kGravity * 0.8 * 0.8 / 2;
  add_body(level, BodyKind::ball, {152 - 2 * 0.8, 80 - 8 - fallen + 0.002}, {2, 2});
  MeetingRun run(level);
  run.step();
  EXPECT_LT(run.body(0).velocity.y, -2);
}

// Its box is just beside the peak: it stands on one point, with no width.
TEST(MeetingEdges, ABallOnTheCornerOfAPeakSlidesDown) {
  for (const bool is_left : {false, true}) {
    Level level = open_level(kGravity, 0);
    put(level, {9, 10}, slope(0, 8));
    put(level, {10, 10}, slope(8, 0));
    add_body(level, BodyKind::ball, {is_left ? 72.0 : 80.0, 60});
    MeetingRun run(level);
    run.step(40);
    EXPECT_GT(run.body(0).box.y, 80) << "it has left the peak";
    EXPECT_GT(std::abs(run.body(0).box.x - 76), 10) << is_left;
  }
}

// The air slows a disc that rolls up a slope along x alone: it leaves the slope, and is back within the
// frame. By then it is over the next tile.
TEST(MeetingEdges, ADiscThatTheAirSlowsStaysOutOfItsSlope) {
  for (const double start : {70.0, 71.3, 72.9, 74.2}) {
    Level level = open_level(kGravity, 0);
    level.tuning.shared.drift_blend = 0.03;
    for (int i = 0; i < 8; ++i) put(level, {5 + i, 10}, slope(8 - i, 7 - i));
    add_body(level, BodyKind::disc, {start, 66}, {-4, 0}, {9, 9});
    MeetingRun run(level);
    for (int frame = 1; frame <= 12; ++frame) {
      run.step();
      // Above the line through the tiles, which falls by an eighth to the right from 40, 80.
      const Vec2 middle = run.body(0).box.center();
      const double height = (80 + (middle.x - 40) / 8 - middle.y) / std::hypot(1.0, 1.0 / 8);
      if (middle.x < 41) break;
      ASSERT_GT(height, 4.5 - 1e-9) << start << ", " << frame;
    }
  }
}

// It rises through a one-way floor, and comes down across it, beside a floor of the same height.
TEST(MeetingEdges, ACircleAcrossAOneWayFloorMeetsTheWall) {
  for (const double speed : {-0.5, -1.5, -3.0}) {
    Level level = open_level(kGravity, 0);
    put(level, {9, 10}, solid());
    for (int column = 10; column < 16; ++column) put(level, {column, 10}, solid(true));
    add_body(level, BodyKind::marble, {90, 77}, {speed, 0}, {10, 10});
    MeetingRun run(level);
    for (int frame = 1; frame <= 60; ++frame) {
      run.step();
      const Vec2 middle = run.body(0).box.center();
      const Vec2 nearest{std::clamp(middle.x, 72.0, 80.0), std::clamp(middle.y, 80.0, 88.0)};
      ASSERT_GT(std::hypot(middle.x - nearest.x, middle.y - nearest.y), 5 - 1e-6) << speed << ", " << frame;
    }
  }
}

// Friction that slowed its last motion must not go on when that has ended.
TEST(MeetingEdges, ADiscThatSettlesBetweenTwoGetsNoSpeed) {
  Level level = open_level(1.125, 0.9);
  for (int i = 0; i < 4; ++i) put(level, {8 + i, 10}, slope(8 - 2 * i, 6 - 2 * i));
  for (int row = 6; row < 11; ++row) put(level, {12, row}, solid());
  for (int start = 0; start < 24; ++start) {
    level.spawns.clear();
    add_body(level, BodyKind::disc, {70 + start * 0.71, 60}, {1, 0});
    MeetingRun run(level);
    const auto energy = [&] {
      const Body& disc = run.body(0);
      return dot(disc.velocity, disc.velocity) / 2 + disc.spin * disc.spin / 4 - 1.125 * disc.box.y;
    };
    double last = energy();
    for (int frame = 1; frame <= 120; ++frame) {
      run.step();
      ASSERT_LT(energy(), last + 1e-6) << start << ", " << frame;
      last = energy();
    }
  }
}

// It is so slow that it leaves the edge only just before the slope, and then is beside it.
TEST(MeetingEdges, AMarbleThatLeavesAnEdgeMeetsTheSlope) {
  for (int start = 0; start < 120; ++start) {
    Level level = open_level(kGravity, 0.9);
    for (int i = 0; i < 4; ++i) put(level, {5 - i, 10 + i}, slope(0, 8));
    put(level, {6, 10}, solid());
    add_body(level, BodyKind::marble, {46, 72}, {-0.3116 - 0.0003 * start, 0});
    MeetingRun run(level);
    for (int frame = 1; frame <= 30; ++frame) {
      run.step();
      const Vec2 middle = run.body(0).box.center();
      if (middle.y - middle.x <= 32 || middle.y > 100) continue;  // not beside the slope
      ASSERT_GT((128 - middle.x - middle.y) / std::sqrt(2.0), 4 - 1e-9) << start << ", " << frame;
    }
  }
}

// px: how far a circle is from the nearest point of a sine, found by samples alone.
double height_over(const Sine& sine, Vec2 middle, double radius) {
  double least = 1e9;
  constexpr int kSamples = 1000;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = middle.x + radius * 1.25 * (2.0 * i / kSamples - 1);
    if (x < sine.x0 || x > sine.x1) continue;
    const double turn = 2 * std::acos(-1.0) * (x - sine.origin) / sine.wavelength;
    least =
        std::min(least, std::hypot(x - middle.x, sine.middle + sine.amplitude * std::sin(turn) - middle.y));
  }
  return least - radius;
}

struct CircleOnSine {
  Sine sine;
  double radius;  // px
};

void expect_outside(const CircleOnSine& scene, const Level& level, int frames) {
  MeetingRun run(level);
  for (int frame = 1; frame <= frames; ++frame) {
    run.step();
    const Vec2 middle = run.body(0).box.center();
    if (middle.x - scene.radius < scene.sine.x0) return;  // past the end it may come from behind
    ASSERT_GT(height_over(scene.sine, middle, scene.radius), -1e-4)
        << scene.sine.x0 << ", from " << level.spawns[0].position.x << ", frame " << frame;
  }
}

// Hollows a little narrower than the circle, a little wider, and much narrower.
constexpr CircleOnSine kHollows[] = {
    {{100, 149, 53, 4, 24.5, 100}, 4}, {{47, 156, 122, 8, 54.5, 47}, 8}, {{59, 113, 150, 12, 27, 59}, 6}};

TEST(MeetingEdges, ACircleInANarrowHollowStaysOutOfIt) {
  for (const CircleOnSine& scene : kHollows) {
    const Sine& sine = scene.sine;
    for (int start = 0; start < 12; ++start) {
      Level level = open_level(kGravity, 0.9);
      level.curves.push_back({"", {sine, Curve::Faces::up}, ""});
      const double x = sine.x0 + sine.wavelength * (0.5 + start / 24.0), size = 2 * scene.radius;
      add_body(level, BodyKind::disc, {x, sine.middle - sine.amplitude - 1.5 * size}, {1 - start / 6.0, 0},
               {size, size});
      expect_outside(scene, level, 60);
    }
  }
}

// The bend of their way changes much within a frame, and they meet the other side from there.
TEST(MeetingEdges, ACircleThatFallsFastKeepsToASine) {
  for (const CircleOnSine& scene : kHollows) {
    const Sine& sine = scene.sine;
    for (int start = 0; start < 24; ++start) {
      Level level = open_level(0, 0.9);
      level.tuning.shared = {};
      level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
      level.curves.push_back({"", {sine, Curve::Faces::up}, ""});
      const double size = 2 * scene.radius;
      add_body(level, start % 2 == 0 ? BodyKind::disc : BodyKind::marble,
               {sine.x0 + start / 2, sine.middle - 40}, {4.9 - 0.4 * start, 0}, {size, size});
      expect_outside(scene, level, 40);
    }
  }
}

}  // namespace talus::meeting_edges_test
