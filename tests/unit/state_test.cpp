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
