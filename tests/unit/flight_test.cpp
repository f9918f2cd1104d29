// Balls of the solver exact under gravity, with `rebound`, beside the parabolas of their flights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <talus/sim/solver.h>

namespace talus::flight_test {

constexpr double kGravity = 0.2;

// A floor from (0, 200) to (400, 200), which leads up by `slope` px a px, and nothing else.
Level level_with_floor(double slope, double bounce, int substeps) {
  Level level;
  level.map = TileMap(60, 60);
  level.tuning.solver = SolverKind::exact;
  level.tuning.exact.gravity = kGravity;
  level.tuning.exact.rebound = 1;
  level.tuning.exact.substeps = substeps;
  level.tuning.shared.floor_bounce = bounce;
  level.tuning.shared.floor_grip = 1;
  level.tuning.shared.drift_blend = 0;
  level.curves.push_back({"floor", {Segment{{0, 300}, {400, 300 - 400 * slope}}, Curve::Faces::up}, ""});
  return level;
}

struct Flight {
  Vec2 place, velocity;
};

// Where the ball is after so many frames by closed forms alone: parabolas, reflected at the line through
// (0, 300) with this slope. start: where the foot is, with the velocity of the flight itself.
Flight closed_form(Flight start, double slope, double bounce, double frames) {
  const double length = std::hypot(1.0, slope);
  const Vec2 normal{-slope / length, -1 / length};
  while (true) {
    const double distance = -((start.place.x - 0) * normal.x + (start.place.y - 300) * normal.y);
    const double into = -(start.velocity.x * normal.x + start.velocity.y * normal.y);
    const double pull = -kGravity * normal.y;
    // distance is negative above the line: -distance = into t + pull t^2 / 2
    const double root = std::sqrt(into * into - 2 * pull * distance);
    const double time = (root - into) / pull;
    const double part = std::min(time, frames);
    Flight next{{start.place.x + start.velocity.x * part,
                 start.place.y + start.velocity.y * part + kGravity * part * part / 2},
                {start.velocity.x, start.velocity.y + kGravity * part}};
    frames -= part;
    if (part < time || frames <= 0) return next;
    const double v = -(next.velocity.x * normal.x + next.velocity.y * normal.y);
    next.velocity = next.velocity + normal * (v * (1 + bounce));
    start = next;
  }
}

void expect_closed_form(double slope, double bounce, int substeps, int frames, double most) {
  SCOPED_TRACE(testing::Message() << "slope " << slope << ", bounce " << bounce << ", " << substeps
                                  << " parts");
  Level level = level_with_floor(slope, bounce, substeps);
  Spawn ball;
  ball.foot = Foot::centre;
  ball.position = {20, 200};
  ball.velocity = {1.3, -2};
  ball.size = {8, 8};
  level.spawns.push_back(ball);
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  // A body between frames has the velocity of the chord of its last frame.
  const Flight start{{24, 208}, {1.3, -2 + kGravity / 2}};
  double worst = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    solver->step(state, {});
    const Rect& box = state.bodies.front().box;
    const Flight there = closed_form(start, slope, bounce, frame);
    worst = std::max({worst, std::abs(box.x + 4 - there.place.x), std::abs(box.bottom() - there.place.y)});
  }
  EXPECT_LT(worst, most);
}

TEST(Flight, FollowsTheClosedFormOnLevelGround) {
  for (const double bounce : {1.0, 0.9})
    for (const int substeps : {1, 2, 3, 4, 16}) expect_closed_form(0, bounce, substeps, 200, 1e-9);
}

TEST(Flight, FollowsTheClosedFormOnSlopes) {
  for (const double slope : {0.25, 0.5})
    for (const int substeps : {1, 2, 5, 16}) expect_closed_form(slope, 1, substeps, 60, 1e-9);
}

// The energy of the flight at a place: of a bounce of 1 it stays.
void expect_energy(const Curve& curve, Vec2 place, Vec2 velocity, int substeps, int frames) {
  SCOPED_TRACE(testing::Message() << substeps << " parts");
  Level level = level_with_floor(0, 1, substeps);
  level.tuning.shared.wall_bounce = 1;
  level.curves = {{"ground", curve, ""}};
  Spawn ball;
  ball.foot = Foot::centre;
  ball.position = place;
  ball.velocity = velocity;
  ball.size = {8, 8};
  level.spawns.push_back(ball);
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  const auto energy = [&] {
    const Body& body = state.bodies.front();
    const double vy = body.velocity.y + kGravity / 2;
    return (body.velocity.x * body.velocity.x + vy * vy) / 2 - kGravity * body.box.y;
  };
  const double start = energy();
  double worst = 0;
  int bounces = 0;
  StepRecord record;
  for (int frame = 0; frame < frames; ++frame) {
    solver->step(state, {}, &record);
    bounces += record.contacts.empty() ? 0 : 1;
    worst = std::max(worst, std::abs(energy() - start));
  }
  EXPECT_GT(bounces, frames / 200);
  EXPECT_LT(worst, 1e-9 * std::abs(start));
}

TEST(Flight, KeepsItsEnergyOnLevelGround) {
  const Curve floor{Segment{{0, 300}, {480, 300}}, Curve::Faces::up};
  for (const int substeps : {1, 2, 16}) expect_energy(floor, {200, 250}, {0, 0}, substeps, 10'000);
}

TEST(Flight, KeepsItsEnergyInAHollow) {
  const Curve hollow{Arc{{240, 0}, 400, 0, 480, false}, Curve::Faces::up};
  for (const int substeps : {1, 2, 16}) expect_energy(hollow, {230, 300}, {0.5, 0}, substeps, 10'000);
}

}  // namespace talus::flight_test
