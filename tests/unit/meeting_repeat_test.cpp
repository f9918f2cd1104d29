// Bodies that meet: a step depends on the scene and the state alone, not on what the solver remembers.
#include <gtest/gtest.h>

#include <initializer_list>

#include "meeting_run.h"
#include "property/random_ground.h"

namespace talus::meeting_repeat_test {

// Bodies above one another in a narrow room: they fall into a heap, and some of them rest.
Level heap(std::initializer_list<BodyKind> kinds, int bodies, std::uint64_t seed) {
  Level level = room_level(14, 16, 0.1);
  Dice dice(seed);
  for (int i = 0; i < bodies; ++i) {
    const Vec2 at{10 + 14.0 * (i % 6) + dice.in(0, 4), 4 + 20.0 * (i / 6) + dice.in(0, 8)};
    add_body(level, kinds.begin()[static_cast<std::size_t>(i) % kinds.size()], at,
             {dice.in(-2, 2), dice.in(-1, 1)});
  }
  return level;
}

// kept: goes on, and records, so that nothing sleeps. unrecorded: bodies may sleep. fresh: a new solver in
// each frame, which remembers nothing.
void expect_same(const Level& level) {
  MeetingRun kept(level), unrecorded(level), fresh(level);
  StepRecord record;
  for (int frame = 1; frame <= 240; ++frame) {
    kept.solver->step(kept.state, {}, &record);
    unrecorded.step();
    fresh.solver = make_solver(fresh.scene);
    fresh.step();
    ASSERT_EQ(kept.state, unrecorded.state) << frame;
    ASSERT_EQ(kept.state, fresh.state) << frame;
  }
}

TEST(MeetingRepeat, HeapsOfMarbles) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) expect_same(heap({BodyKind::marble}, 30, seed));
}

// A crowd leaves boxes a little inside of one another.
TEST(MeetingRepeat, HeapsOfCratesAndDiscs) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
    expect_same(heap({BodyKind::crate, BodyKind::disc, BodyKind::ball}, 20, seed));
}

}  // namespace talus::meeting_repeat_test
