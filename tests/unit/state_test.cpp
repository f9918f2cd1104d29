// States: bodies at the start, bodies after edits of the level, and the hash of a state.

#include <talus/sim/state.h>

#include <gtest/gtest.h>

#include <cmath>

#include "level_picture.h"

namespace talus::state_test {

TEST(State, BodiesAreNumberedInSceneOrder) {
  const State state = initial_state(compile_scene(level_of({".o",  //
                                                            "o."})));
  ASSERT_EQ(state.bodies.size(), 2u);
  EXPECT_EQ(state.bodies[0].box, (Rect{0, 8, 8, 8}));
  EXPECT_EQ(state.bodies[0].id, 1);
  EXPECT_EQ(state.bodies[1].box, (Rect{8, 0, 8, 8}));
  EXPECT_EQ(state.bodies[1].id, 2);
  EXPECT_EQ(state.find(2), &state.bodies[1]);
  EXPECT_EQ(state.find(3), nullptr);
  EXPECT_EQ(state.find(0), nullptr);
}

TEST(CarryOver, KeepsBodiesAddsNewOnesAndRemovesOldOnes) {
  State state = initial_state(compile_scene(level_of({"oo."})));
  state.frame = 7;
  state.bodies[1].box.y = 20;
  state.grabbed = 2;
  const State next = carry_over(state, compile_scene(level_of({".oo"})));
  ASSERT_EQ(next.bodies.size(), 2u);
  EXPECT_EQ(next.frame, 7);
  EXPECT_EQ(next.bodies[0], state.bodies[1]);  // still where it was, not back at its tile
  EXPECT_EQ(next.bodies[1].id, 3);
  EXPECT_EQ(next.bodies[1].box, (Rect{16, 0, 8, 8}));
  EXPECT_EQ(next.grabbed, 2);
}

TEST(CarryOver, IdsAreNotReusedAndARemovedBodyIsReleased) {
  State state = initial_state(compile_scene(level_of({"oo"})));
  state.grabbed = 2;
  state = carry_over(state, compile_scene(level_of({"o."})));
  EXPECT_EQ(state.grabbed, 0);
  state = carry_over(state, compile_scene(level_of({"oo"})));
  ASSERT_EQ(state.bodies.size(), 2u);
  EXPECT_EQ(state.bodies[1].id, 3);
}

TEST(CarryOver, KindAndFootFollowTheSpawn) {
  Level level = level_of({"..."});
  level.spawns.resize(1);
  State state = initial_state(compile_scene(level));
  state.bodies[0].box.y = 20;
  level.spawns[0].kind = BodyKind::player;
  const State next = carry_over(state, compile_scene(level));
  EXPECT_EQ(next.bodies[0].kind, BodyKind::player);
  EXPECT_EQ(next.bodies[0].foot, Foot::centre);
  EXPECT_EQ(next.bodies[0].box, state.bodies[0].box);
}

// Neither a slope that is drawn over the running player nor a filled rectangle may bury it.
TEST(CarryOver, LiftsBodiesOutOfNewGround) {
  for (const bool single : {false, true}) {
    for (const BodyKind kind : {BodyKind::player, BodyKind::ball}) {
      Level level = level_of({"........", "........", "........", "........", "........", "########"});
      level.tuning.solver = SolverKind::exact;
      level.tuning.exact.single_precision = single ? 1 : 0;
      level.spawns.resize(1);
      level.spawns[0].position = {28, 32};
      level.spawns[0].kind = kind;
      level.spawns[0].size = {8, 8};
      const State state = initial_state(compile_scene(level));
      EXPECT_EQ(carry_over(state, compile_scene(level)).bodies[0].box.y, 32);
      for (int y = 2; y < 5; ++y)
        for (int x = 0; x < 8; ++x) level.map.set({x, y}, 1);
      EXPECT_EQ(carry_over(state, compile_scene(level)).bodies[0].box, (Rect{28, 8, 8, 8}));
      level.map.set({3, 2}, 3);
      level.map.set({4, 2}, 4);
      const double y = carry_over(state, compile_scene(level)).bodies[0].box.y;
      EXPECT_GT(y, 8) << "on the slope";
      EXPECT_LT(y, 16);
    }
  }
}

TEST(StateHash, ChangesWithTheLastBitOfAnyNumber) {
  const State state = initial_state(compile_scene(level_of({"o"})));
  const std::uint64_t hash = state_hash(state);
  for (double Rect::*number : {&Rect::x, &Rect::y}) {
    State other = state;
    other.bodies[0].box.*number = std::nextafter(other.bodies[0].box.*number, 1);
    EXPECT_NE(state_hash(other), hash);
  }
  State other = state;
  other.bodies[0].velocity.x = -0.0;
  EXPECT_NE(state_hash(other), hash);
  other = state;
  ++other.frame;
  EXPECT_NE(state_hash(other), hash);
}

TEST(StateHash, IsFnv1aOverTheNumbersLowByteFirst) {
  State state;
  state.frame = 1;  // sixteen bytes: 01 00.. (frame), 00.. (grabbed)
  std::uint64_t expected = 0xcbf29ce484222325;
  for (int i = 0; i < 16; ++i) expected = (expected ^ (i == 0 ? 1u : 0u)) * 0x100000001b3;
  EXPECT_EQ(state_hash(state), expected);
}

}  // namespace talus::state_test
