// Events of a step: what hit something, landed or left the ground.
#include <gtest/gtest.h>

#include <cmath>

#include <talus/sim/solver.h>
#include "level_picture.h"

namespace talus::step_events_test {

using Kind = StepEvent::Kind;

Level exact_level(BodyPairs pairs) {
  Level level = level_of({"#..............#", "#..............#", "#..............#", "################"});
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = static_cast<double>(pairs);
  level.tuning.shared.drift_blend = 0;
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0;
  level.tuning.exact.gravity = 0.25;
  level.tuning.exact.rebound = 1;
  return level;
}

Spawn body(BodyKind kind, Vec2 at, Vec2 velocity = {}) {
  Spawn spawn;
  spawn.position = at;
  spawn.velocity = velocity;
  spawn.kind = kind;
  spawn.size = {8, 8};
  return spawn;
}

struct Heard {
  std::int64_t frame;
  StepEvent event;
};

// Runs a level, and returns its events. held: the keys from frame 10 on.
std::vector<Heard> heard_in(const Level& level, int frames, const Input& held = {}) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene), silent = state;
  StepRecord whole, record;
  record.only_events = true;
  std::vector<Heard> heard;
  for (int i = 0; i < frames; ++i) {
    State again = state;
    const Input keys = i < 9 ? Input() : held;
    solver->step(again, keys, &whole);
    solver->step(silent, keys);
    solver->step(state, keys, &record);
    EXPECT_EQ(state, silent);
    EXPECT_EQ(state, again);
    EXPECT_EQ(record.events.size(), whole.events.size());
    EXPECT_TRUE(record.paths.empty() && record.contacts.empty() && record.work == 0);
    for (const StepEvent& event : record.events) heard.push_back({state.frame, event});
  }
  return heard;
}

std::vector<Heard> of_kind(const std::vector<Heard>& all, Kind kind) {
  std::vector<Heard> found;
  for (const Heard& one : all) {
    if (one.event.kind == kind) found.push_back(one);
  }
  return found;
}

TEST(StepEvents, AFallHitsTheFloorByItsMomentum) {
  for (const BodyPairs pairs : {BodyPairs::pass, BodyPairs::block, BodyPairs::meet}) {
    for (const double bounce : {0.0, 0.5}) {
      Level level = exact_level(pairs);
      level.tuning.shared.floor_bounce = bounce;
      level.tuning.exact.substeps = 3;
      level.spawns = {body(BodyKind::ball, {40, 6})};
      const auto heard = heard_in(level, 30);
      const auto hits = of_kind(heard, Kind::hit);
      ASSERT_GE(hits.size(), 1u);
      const StepEvent& hit = hits[0].event;
      EXPECT_EQ(hit.body, 1);
      EXPECT_EQ(hit.other, 0);
      EXPECT_EQ(hit.normal, (Vec2{0, -1}));
      // But for bodies that meet, the velocity of a state is that of half a frame before.
      const double start = pairs == BodyPairs::meet ? 0 : 0.25 / 2;
      EXPECT_NEAR(hit.impulse, (1 + bounce) * std::sqrt(start * start + 2 * 0.25 * 10), 1e-12);
      ASSERT_EQ(of_kind(heard, Kind::landed).size(),
                bounce == 0 ? 1u : of_kind(heard, Kind::left).size() + 1);
    }
  }
}

TEST(StepEvents, AtRestThereAreNone) {
  for (const BodyPairs pairs : {BodyPairs::pass, BodyPairs::block, BodyPairs::meet}) {
    for (const double gravity : {0.25, 0.0}) {
      Level level = exact_level(pairs);
      level.tuning.exact.gravity = gravity;
      level.tuning.shared.floor_bounce = 0.5;
      level.spawns = {body(BodyKind::ball, {40, 16}), body(BodyKind::crate, {60, 16}),
                      body(BodyKind::crate, {60, 8}), body(BodyKind::player, {80, 16})};
      const auto heard = heard_in(level, 200);
      EXPECT_TRUE(heard.empty() || heard.back().frame <= 40) << heard.back().frame;
    }
  }
}

TEST(StepEvents, APlayerJumpsLandsAndMeetsAWall) {
  for (const BodyPairs pairs : {BodyPairs::pass, BodyPairs::block, BodyPairs::meet}) {
    Level level = exact_level(pairs);
    level.spawns = {body(BodyKind::player, {40, 16})};
    Input up, right;
    up.jump = right.right = true;
    const auto jump = heard_in(level, 60, up);
    ASSERT_EQ(jump.size(), 4u);  // it stands, jumps, and comes down
    EXPECT_EQ(jump[0].event.kind, Kind::landed);
    EXPECT_EQ(jump[1].event.kind, Kind::left);
    EXPECT_EQ(jump[2].event.kind, Kind::hit);
    EXPECT_GT(jump[2].event.impulse, 1);
    EXPECT_EQ(jump[3].event.kind, Kind::landed);
    EXPECT_EQ(jump[3].frame, jump[2].frame);
    const auto walls = of_kind(heard_in(level, 120, right), Kind::hit);
    ASSERT_EQ(walls.size(), 1u);  // and not again while the key presses it against the wall
    EXPECT_EQ(walls[0].event.normal, (Vec2{-1, 0}));
    EXPECT_NEAR(walls[0].event.impulse, level.tuning.player.run_speed, 1e-12);
  }
}

TEST(StepEvents, BodiesThatMeetHitOneAnother) {
  Level level = exact_level(BodyPairs::meet);
  level.tuning.exact.gravity = level.tuning.shared.fall_blend = 0;
  level.spawns = {body(BodyKind::crate, {40, 4}, {2, 0}), body(BodyKind::crate, {60, 4})};
  level.spawns[1].size = {16, 16};
  const auto heard = heard_in(level, 10);
  ASSERT_EQ(heard.size(), 2u);
  const double reduced = 1.0 * 4 / 5;
  for (int i = 0; i < 2; ++i) {
    const StepEvent& event = heard[static_cast<std::size_t>(i)].event;
    EXPECT_EQ(event.body + event.other, 3);
    EXPECT_EQ(event.normal.x, event.body == 1 ? -1 : 1);
    EXPECT_NEAR(event.impulse, reduced * 2 * 1.1, 1e-12);
  }
}

TEST(StepEvents, OtherSolversHaveNone) {
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    Level level = exact_level(BodyPairs::block);
    level.tuning.solver = solver;
    level.spawns = {body(BodyKind::ball, {40, 0})};
    EXPECT_TRUE(heard_in(level, 60).empty());
  }
}

}  // namespace talus::step_events_test
