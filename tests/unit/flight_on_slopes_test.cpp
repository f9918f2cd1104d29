// Balls of the solver exact that rebound under gravity on slopes and curves, beside the parabolas of their
// flights and their meetings with the ground itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <talus/sim/solver.h>

#include "reference/flight_over_ground.h"

namespace talus::flight_on_slopes_test {

using reference::BallFlight;
using reference::FlightOverGround;
using reference::HeightGround;
using reference::Precise;

constexpr double kSize = 8;  // px, of a ball
constexpr double kMax = 1e-9;

Level open_level(double gravity, int substeps) {
  Level level;
  level.map = TileMap(100, 60);
  level.tuning.exact.gravity = gravity;
  level.tuning.exact.rebound = 1;
  level.tuning.exact.substeps = substeps;
  level.tuning.shared.drift_blend = 0;
  level.tuning.shared.floor_bounce = 1;
  level.tuning.shared.floor_grip = 1;
  level.tuning.shared.wall_bounce = 1;
  return level;
}

struct Start {
  Vec2 foot;  // px, the middle of the bottom
  Vec2 velocity;
};

struct Play {
  Play(Level level, const Start& start, Foot foot) : gravity(level.tuning.exact.gravity) {
    Spawn ball;
    ball.foot = foot;
    ball.size = {kSize, kSize};
    ball.position = {start.foot.x - kSize / 2, start.foot.y - kSize};
    ball.velocity = start.velocity;
    level.spawns.push_back(ball);
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    solver = make_solver(scene);
    state = initial_state(*scene);
  }
  // Between frames a body has the velocity of the chord of its last frame.
  BallFlight flight() const {
    const Body& ball = state.bodies.front();
    return {ball.box.x + kSize / 2, ball.box.bottom(), ball.velocity.x, ball.velocity.y + gravity / 2, false};
  }
  double energy() const {
    const BallFlight at = flight();
    return static_cast<double>((at.vx * at.vx + at.vy * at.vy) / 2 - gravity * at.y);
  }
  double gravity;
  std::unique_ptr<Solver> solver;
  State state;
};

double distance(const BallFlight& a, const BallFlight& b) {
  return static_cast<double>(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)));
}

// Ground on which balls are compared with the reference while they are between two x, px.
struct Scenery {
  Level (*level)(double gravity, int substeps);
  HeightGround ground;
  double left, right;
};

enum class Restart { never, after_each_bounce };

// Errors grow from bounce to bounce on hills, so there the reference starts again from the ball after each.
// Returns how many bounces were compared.
int expect_reference(const Scenery& scenery, double gravity, Foot foot, int substeps, Restart restart) {
  SCOPED_TRACE(testing::Message() << "gravity " << gravity << ", " << substeps << " parts, foot "
                                  << static_cast<int>(foot));
  const FlightOverGround reference(scenery.ground, gravity, foot == Foot::box ? kSize : 0);
  constexpr int kStarts = 7, kFrames = 120;
  double worst = 0;
  int bounces = 0;
  for (int i = 0; i < kStarts; ++i) {
    const double x = scenery.left + (scenery.right - scenery.left) * (i + 1.3) / (kStarts + 1.7);
    const double above = 6 + 7.3 * ((i * 3) % kStarts);
    Play play(scenery.level(gravity, substeps),
              {{x, static_cast<double>(reference.support(x).y) - above}, {1.1 * i - 3.1, -0.2 * i}}, foot);
    BallFlight there = play.flight();
    for (int frame = 0; frame < kFrames; ++frame) {
      const int hits = reference.frame(there);
      if (there.x < scenery.left || there.x > scenery.right || there.is_slow) break;
      play.solver->step(play.state, {});
      worst = std::max(worst, distance(play.flight(), there));
      bounces += hits;
      if (hits > 0 && restart == Restart::after_each_bounce) there = play.flight();
    }
  }
  EXPECT_LT(worst, kMax);
  return bounces;
}

void expect_reference_of_all(const Scenery& scenery, Restart restart) {
  int bounces = 0;
  for (const double gravity : {0.2, 1.0})
    for (const Foot foot : {Foot::box, Foot::centre})
      for (const int substeps : {1, 2, 3, 4, 8, 16})
        bounces += expect_reference(scenery, gravity, foot, substeps, restart);
  EXPECT_GT(bounces, 200);
}

Level with(Level level, Curve::Faces faces, decltype(Curve::form) form) {
  level.curves.push_back({"ground", {std::move(form), faces}, ""});
  return level;
}
Level with(Level level, decltype(Curve::form) form) { return with(std::move(level), Curve::Faces::up, form); }

// Through (400, 300), `slope` px up a px.
template <int eighths>
Scenery line() {
  static constexpr double kSlope = eighths / 8.0, kHalf = kSlope * kSlope >= 1 ? 96 : 192;
  return {[](double gravity, int substeps) {
            return with(open_level(gravity, substeps),
                        Segment{{400 - kHalf, 300 + kHalf * kSlope}, {400 + kHalf, 300 - kHalf * kSlope}});
          },
          {[](Precise x) { return 300 - (x - 400) * kSlope; }, [](Precise) { return Precise(-kSlope); }, {}},
          400 - kHalf + 10,
          400 + kHalf - 10};
}

TEST(FlightOnSlopes, FollowsLines) {
  for (const Scenery& scenery : {line<2>(), line<8>(), line<-5>(), line<12>(), line<-12>()}) {
    int bounces = 0;
    for (const Foot foot : {Foot::box, Foot::centre})
      for (const int substeps : {1, 2, 3, 4, 8, 16})
        bounces += expect_reference(scenery, 0.2, foot, substeps, Restart::never);
    EXPECT_GT(bounces, 30);
  }
}

TEST(FlightOnSlopes, FollowsTiles) {
  const Scenery stairs{[](double gravity, int substeps) {
                         Level level = open_level(gravity, substeps);
                         level.tile_shapes[1] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
                         for (int i = 0; i < 40; ++i) level.map.set({30 + i, 50 - i}, 1);
                         return level;
                       },
                       {[](Precise x) { return 408 - (x - 240); }, [](Precise) { return Precise(-1); }, {}},
                       252,
                       548};
  expect_reference_of_all(stairs, Restart::never);
}

// Of a circle around (400, 250).
template <bool upper>
Scenery arc() {
  constexpr Precise kSign = upper ? -1 : 1;
  const auto half = [](Precise x) { return std::sqrt(150 * 150 - (x - 400) * (x - 400)); };
  return {[](double gravity, int substeps) {
            return with(open_level(gravity, substeps), Arc{{400, 250}, 150, 260, 540, upper});
          },
          {[=](Precise x) { return 250 + kSign * half(x); },
           [=](Precise x) { return -kSign * (x - 400) / half(x); },
           upper ? std::vector<Precise>{400} : std::vector<Precise>{}},
          275,
          525};
}

TEST(FlightOnSlopes, FollowsHills) { expect_reference_of_all(arc<true>(), Restart::after_each_bounce); }

TEST(FlightOnSlopes, FollowsHollows) { expect_reference_of_all(arc<false>(), Restart::after_each_bounce); }

TEST(FlightOnSlopes, FollowsSines) {
  constexpr Precise kTurn = 6.283185307179586476925286766559L;
  const Scenery waves{[](double gravity, int substeps) {
                        return with(open_level(gravity, substeps), Sine{200, 600, 300, 4, 32, 200});
                      },
                      {[](Precise x) { return 300 + 4 * std::sin(kTurn * (x - 200) / 32); },
                       [](Precise x) { return kTurn / 8 * std::cos(kTurn * (x - 200) / 32); },
                       {}},
                      215,
                      585};
  Scenery with_tops = waves;
  for (int i = 0; i <= 12; ++i) with_tops.ground.tops.push_back(192 + 32 * i);
  expect_reference_of_all(with_tops, Restart::after_each_bounce);
}

TEST(FlightOnSlopes, FollowsParabolas) {
  const Scenery hollow{[](double gravity, int substeps) {
                         return with(open_level(gravity, substeps), Parabola{{200, 300}, {600, 300}, 450});
                       },
                       {[](Precise x) { return 300 + (x - 200) * (600 - x) * 300 / 160'000; },
                        [](Precise x) { return (800 - 2 * x) * 300 / 160'000; },
                        {}},
                       215,
                       585};
  expect_reference_of_all(hollow, Restart::after_each_bounce);
}

// With both corners at once: neither side of the hollow turns it.
TEST(FlightOnSlopes, ABoxFallsStraightIntoAHollow) {
  Play play(arc<false>().level(0.2, 1), {{400, 320}, {0, 0}}, Foot::box);
  bool rose = false;
  for (int frame = 0; frame < 200; ++frame) {
    play.solver->step(play.state, {});
    EXPECT_EQ(play.state.bodies.front().box.x, 400 - kSize / 2);
    rose = rose || play.state.bodies.front().velocity.y < -1;
  }
  EXPECT_TRUE(rose);
}

void expect_energy(const Level& level, Vec2 foot_at, Foot foot) {
  Play play(level, {foot_at, {0.7, 0}}, foot);
  const double start = play.energy();
  double worst = 0;
  for (int frame = 0; frame < 10'000; ++frame) {
    play.solver->step(play.state, {});
    worst = std::max(worst, std::abs(play.energy() - start));
  }
  EXPECT_LT(worst, 1e-9 * std::abs(start));
  EXPECT_GT(play.flight().x, 250);
  EXPECT_LT(play.flight().x, 550);
}

// Ground from x = 250 to 550 between two walls.
Level between_walls(double gravity, int substeps, decltype(Curve::form) form) {
  Level level = with(open_level(gravity, substeps), std::move(form));
  level = with(std::move(level), Curve::Faces::down, Segment{{250, 0}, {250, 300}});
  return with(std::move(level), Curve::Faces::up, Segment{{550, 0}, {550, 300}});
}

TEST(FlightOnSlopes, KeepsItsEnergyInABowl) {
  for (const int substeps : {1, 2, 16})
    for (const Foot foot : {Foot::box, Foot::centre})
      expect_energy(between_walls(0.2, substeps, Arc{{400, 200}, 170, 250, 550, false}), {340, 150}, foot);
}

TEST(FlightOnSlopes, KeepsItsEnergyOnAZigzag) {
  for (const int substeps : {1, 2, 16})
    for (const Foot foot : {Foot::box, Foot::centre})
      expect_energy(between_walls(0.2, substeps, Polyline{250, 550, {300, 340, 310, 330, 300, 350, 300}}),
                    {340, 250}, foot);
}

}  // namespace talus::flight_on_slopes_test
