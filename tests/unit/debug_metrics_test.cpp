// Numbers of a body in a frame.
#include "debug/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "level_picture.h"
#include "recorded_frames.h"

namespace talus::debug_metrics_test {

Level exact_level(std::initializer_list<std::string_view> rows) {
  Level level = level_of(rows);
  level.tuning.solver = SolverKind::exact;
  return level;
}

// A body in a level with a floor at y = 24 and a tile in the air from (24, 8) to (32, 16).
class GroundMetrics : public testing::Test {
 protected:
  GroundMetrics()
      : recorded_(
            exact_level({"......", "...#..", "......", "######", "######", "######", "######", "######"}), 0),
        frame_(recorded_.at(0)) {}

  double of(Metric metric, double x, double y, bool grounded = true) {
    Body body = body_at(1, x, y);
    body.gait.grounded = grounded;
    return measure(metric, frame_, body);
  }

  RecordedFrames recorded_;
  Frame frame_;
};

TEST_F(GroundMetrics, Penetration) {
  EXPECT_EQ(of(Metric::penetration, 0, 10), 0);
  EXPECT_EQ(of(Metric::penetration, 0, 16), 0) << "standing on it";
  EXPECT_EQ(of(Metric::penetration, 0, 17.5), 1.5);
  EXPECT_EQ(of(Metric::penetration, 17, 6), 1) << "out to the left";
  EXPECT_EQ(of(Metric::penetration, 16, 40), std::numeric_limits<double>::infinity()) << "deep inside";
  frame_.ground = nullptr;
  EXPECT_TRUE(std::isnan(of(Metric::penetration, 0, 17)));
}

TEST_F(GroundMetrics, FloorError) {
  EXPECT_EQ(of(Metric::floor_error, 0, 16), 0);
  EXPECT_EQ(of(Metric::floor_error, 0, 17.5), 1.5) << "below the floor";
  EXPECT_EQ(of(Metric::floor_error, 0, 15.25), -0.75) << "above it";
  EXPECT_TRUE(std::isnan(of(Metric::floor_error, 0, 15.25, false))) << "in the air";
  EXPECT_TRUE(std::isnan(of(Metric::floor_error, 17, 6))) << "the way out is sideways";
}

// The corners of a disc's box may be in a slope.
TEST(DiscMetrics, ADiscOnASlopeIsNotInside) {
  Level level = exact_level({"......", "......", "......", "......"});
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.curves.push_back({"", {Segment{{0, 0}, {32, 32}}, Curve::Faces::up}, ""});
  level.spawns.push_back({.name = "", .position = {}, .velocity = {}, .extra = "", .kind = BodyKind::disc});
  const RecordedFrames recorded(level, 0);
  const Frame frame = recorded.at(0);
  Body disc = body_at(1, 16 + 4 * std::sqrt(0.5) - 4, 16 - 4 * std::sqrt(0.5) - 4);
  disc.kind = BodyKind::disc;
  disc.gait.grounded = true;
  EXPECT_EQ(measure(Metric::penetration, frame, disc), 0);
  EXPECT_TRUE(std::isnan(measure(Metric::floor_error, frame, disc)));
  disc.kind = BodyKind::crate;
  EXPECT_EQ(measure(Metric::penetration, frame, disc), 0) << "thin lines have no inside";
  level.curves.clear();
  level.map.set({2, 2}, 1);
  const RecordedFrames on_tile(level, 0);
  Body corner = body_at(1, 8.75, 8.75);  // its box is in the tile, its circle is not
  EXPECT_EQ(measure(Metric::penetration, on_tile.at(0), corner), 0.75);
  corner.kind = BodyKind::disc;
  EXPECT_EQ(measure(Metric::penetration, on_tile.at(0), corner), 0);
}

TEST_F(GroundMetrics, GroundIsCompiledForSolversWithoutIt) {
  const Level level = level_of({"..", "##"});
  const Scene scene = compile_scene(level);
  ASSERT_EQ(scene.ground, nullptr);
  const auto ground = measured_ground(scene, level);
  EXPECT_TRUE(ground->is_solid({1, 1}));
  const Scene exact = compile_scene(exact_level({"..", "##"}));
  EXPECT_EQ(measured_ground(exact, level), exact.ground);
}

TEST(Metrics, NormalAngle) {
  MadeFrames made({state_of({body_at(1, 0, 0)})});
  Frame& frame = made.frames[0];
  frame.record.contacts.resize(1);
  ContactRecord& contact = frame.record.contacts[0];
  contact.body = 1;
  contact.handled = true;
  const auto angle = [&](Vec2 normal) {
    contact.normal = normal;
    return measure(Metric::normal_angle, frame, frame.state.bodies[0]);
  };
  EXPECT_EQ(angle({0, -1}), 0);
  EXPECT_EQ(angle({1, 0}), 90);
  EXPECT_EQ(angle({-1, 0}), -90);
  EXPECT_EQ(angle({0, 1}), 180);
  EXPECT_EQ(angle({-0.0, 1}), 180);
  EXPECT_DOUBLE_EQ(angle({std::sqrt(0.5), -std::sqrt(0.5)}), 45);
}

TEST(Metrics, TheLastContactWithAnEffectGivesTheNormal) {
  MadeFrames made({state_of({body_at(1, 0, 0), body_at(2, 50, 0)})});
  Frame& frame = made.frames[0];
  ContactRecord floor;
  floor.body = 1;
  floor.normal = {0, -1};
  floor.handled = true;
  ContactRecord unhandled = floor;
  unhandled.normal = {1, 0};
  unhandled.handled = false;
  ContactRecord of_other = floor;
  of_other.body = 2;
  of_other.normal = {-1, 0};
  frame.record.contacts = {floor, unhandled, of_other};
  EXPECT_EQ(measure(Metric::normal_y, frame, frame.state.bodies[0]), -1);
  EXPECT_EQ(measure(Metric::contacts, frame, frame.state.bodies[0]), 1);

  // The article corrects a body that has crossed a slope's box. The normal of that contact is the slope's.
  ContactRecord slope = floor;
  slope.response = Response::cross;
  slope.normal = {-1, 0};
  slope.slope = SlopeProbe{{}, 0.5, 20, 12, {-0.6, -0.8}, false};
  frame.record.contacts = {slope};
  EXPECT_TRUE(std::isnan(measure(Metric::normal_y, frame, frame.state.bodies[0])));
  EXPECT_EQ(measure(Metric::slope_delta, frame, frame.state.bodies[0]), 0.5);
  frame.record.contacts[0].slope->corrected = true;
  EXPECT_EQ(measure(Metric::normal_y, frame, frame.state.bodies[0]), -0.8);
}

TEST(Metrics, FlightKeepsItsEnergyUnderConstantGravity) {
  Level level = exact_level({"o.......", "........", "........", "........", "........", "########"});
  level.tuning.exact.gravity = 0.125;
  const RecordedFrames recorded(level, 20);
  const auto energy = [&](std::int64_t frame) {
    return measure(Metric::energy, recorded.at(frame), recorded.at(frame).state.bodies[0]);
  };
  EXPECT_EQ(energy(0), 0.0625 * 0.0625 / 2 - 0.125 * 4);
  for (std::int64_t frame = 1; frame <= 20; ++frame) EXPECT_EQ(energy(frame), energy(0)) << frame;
}

TEST(Metrics, BodiesThatMeetHaveTheirOwnContactsAndEnergy) {
  Level level = exact_level({"o.o.....", "........", "........", "........", "........", "########"});
  level.tuning.exact.gravity = 0.125;
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.tuning.shared.floor_bounce = 1;
  const RecordedFrames recorded(level, 60);
  const auto of = [&](Metric metric, std::int64_t frame, std::size_t body) {
    return measure(metric, recorded.at(frame), recorded.at(frame).state.bodies[body]);
  };
  int hits = 0;
  for (std::int64_t frame = 1; frame <= 60; ++frame) {
    for (const std::size_t body : {0u, 1u}) {
      EXPECT_NEAR(of(Metric::energy, frame, body), -0.125 * 4, 1e-12) << frame;
      const bool hit = of(Metric::hit, frame, body) > 0;
      EXPECT_EQ(of(Metric::contacts, frame, body), hit ? 1 : 0) << frame;
      EXPECT_EQ(of(Metric::landed, frame, body), hit ? 1 : 0) << frame;
      EXPECT_EQ(of(Metric::left_ground, frame, body), frame > 1 ? of(Metric::landed, frame - 1, body) : 0);
      hits += hit ? 1 : 0;
    }
  }
  EXPECT_EQ(hits, 2);
}

TEST(Metrics, EnergyOfTheArticlesFall) {
  MadeFrames made({state_of({body_at(1, 0, 10, {3, 4})})});
  EXPECT_EQ(measure(Metric::energy, made.frames[0], made.frames[0].state.bodies[0]), 12.5 - 0.075 * 5 * 14);
}

// A ball falls onto a floor and rests there, by each solver.
TEST(Metrics, GroundedByEverySolver) {
  for (const SolverKind solver : solver_kinds()) {
    Level level = level_of({"o..", "...", "###"});
    level.tuning.solver = solver;
    level.tuning.shared.floor_bounce = 0;
    const RecordedFrames recorded(level, 60);
    const auto grounded = [&](std::int64_t frame) {
      return measure(Metric::grounded, recorded.at(frame), recorded.at(frame).state.bodies[0]);
    };
    EXPECT_EQ(grounded(0), 0) << solver_name(solver);
    EXPECT_EQ(grounded(1), 0) << solver_name(solver);
    EXPECT_EQ(grounded(60), 1) << solver_name(solver);
    EXPECT_NEAR(measure(Metric::floor_error, recorded.at(60), recorded.at(60).state.bodies[0]), 0, 1e-9);
  }
}

// A ball rolls up a slope of the article: its corner sinks into the ground, as the ball follows it by its
// centre.
TEST(Metrics, TheArticleSinksIntoSlopes) {
  const auto deepest = [](SolverKind solver) {
    Level level = level_of({"........", ".o......", ".../-...", "########"});
    level.tuning.solver = solver;
    level.tuning.shared.drift_speed = 1;
    level.tuning.shared.drift_blend = 1;
    level.tuning.shared.floor_bounce = 0;
    const RecordedFrames recorded(level, 40);
    double most = 0;
    for (std::int64_t frame = 0; frame <= recorded.last(); ++frame)
      most = std::max(most,
                      measure(Metric::penetration, recorded.at(frame), recorded.at(frame).state.bodies[0]));
    return most;
  };
  EXPECT_GT(deepest(SolverKind::article), 1.9);
  EXPECT_LE(deepest(SolverKind::article), 3);
  EXPECT_EQ(deepest(SolverKind::exact), 0);
  EXPECT_LT(deepest(SolverKind::bump), 1e-9);
}

}  // namespace talus::debug_metrics_test
