// Piles of discs that meet come to rest, and then cost next to nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "meeting_run.h"
#include "property/random_ground.h"
#include "sim/meet/meeting.h"

namespace talus::meeting_pile_test {

// Discs of many sizes above one another in a room.
Level heap(int bodies, std::uint64_t seed) {
  constexpr int kHeight = 40;
  Level level = room_level(14, kHeight, 0.2);
  Dice dice(seed);
  for (int i = 0; i < bodies; ++i) {
    const double size = dice.in(6, 10);
    const Vec2 at{10 + 15.0 * (i % 6) + dice.in(0, 4), 8.0 * kHeight - 24 - 14 * (i / 6)};
    add_body(level, BodyKind::disc, at, {dice.in(-0.5, 0.5), 0}, {size, size});
  }
  return level;
}

TEST(MeetingPile, OfDiscsComesToRestAndSleeps) {
  for (const int substeps : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      Level level = heap(60, seed);
      level.tuning.exact.substeps = substeps;
      MeetingRun run(level);
      Meeting meeting(run.scene);
      for (int i = 0; i < 400; ++i) meeting.step(run.state, {}, nullptr, nullptr);
      const std::vector<Body> before = run.state.bodies;
      for (int i = 0; i < 100; ++i) ASSERT_LE(meeting.step(run.state, {}, nullptr, nullptr), 4 * 60) << seed;
      EXPECT_EQ(run.state.bodies, before);
      for (const Body& body : before) EXPECT_EQ(body.spin, 0);
    }
  }
}

// What rests needs no memory to do so: a solver that knows nothing of the steps before changes no bit.
TEST(MeetingPile, AtRestHasTheBitsOfAFreshSolver) {
  MeetingRun run(heap(40, 4));
  run.step(400);
  const std::vector<Body> before = run.state.bodies;
  for (int i = 0; i < 10; ++i) {
    run.solver = make_solver(run.scene);
    run.step();
    ASSERT_EQ(run.state.bodies, before) << i;
  }
}

TEST(MeetingPile, ADiscThatFallsOnAPileWakesIt) {
  Level level = heap(30, 5);
  MeetingRun run(level);
  run.step(400);
  const std::vector<Body> before = run.state.bodies;
  run.state.bodies[29].box.y = 20;
  run.state.bodies[29].velocity = {0, 8};
  run.step(100);
  int moved = 0;
  for (std::size_t i = 0; i < 29; ++i) moved += !(run.body(i).box == before[i].box);
  EXPECT_GT(moved, 0);
}

// How far an impact reaches into a pile is found by places, not by the order of the bodies.
TEST(MeetingPile, TheOrderOfDiscsChangesNoBit) {
  const Level level = heap(36, 6);
  Level turned = level;
  std::reverse(turned.spawns.begin(), turned.spawns.end());
  MeetingRun one(level), other(turned);
  for (int frame = 1; frame <= 150; ++frame) {
    one.step();
    other.step();
    for (std::size_t i = 0; i < 36; ++i) {
      ASSERT_EQ(one.body(i).box, other.body(35 - i).box) << frame;
      ASSERT_EQ(one.body(i).spin, other.body(35 - i).spin) << frame;
    }
  }
}

}  // namespace talus::meeting_pile_test
