// Actions that need many steps: however slow a step is, the window gets its turn in between.
#include <gtest/gtest.h>

#include <algorithm>

#include "faults/slow_clock.h"
#include "folder_test.h"
#include "level_picture.h"
#include "recorded_frames.h"
#include "session/debugger/breakpoints.h"
#include "session/session.h"

namespace talus::session_slow_steps_test {

namespace act = action;

constexpr int kFrames = 6;
constexpr int kMaxSteps = 3;  // in a turn

Level one_ball() {
  Level level = level_of({"..........", "..........", "##########"});
  level.tuning.solver = SolverKind::exact;
  level.spawns.resize(1);
  level.spawns[0].position = {20.5, 4};
  return level;
}

class SlowSteps : public FolderTest {
 protected:
  SlowSteps() {
    for (int i = 0; i < kFrames; ++i) session_.apply(act::StepFrame{});
    last_ = session_.state();
    session_.apply(act::SeekStart{});
  }
  const Timeline& timeline() const { return session_.timeline(); }
  // The number of steps that this call makes.
  std::int64_t steps_of(FunctionRef<void()> call) const {
    const std::int64_t before = timeline().steps_again();
    call();
    return timeline().steps_again() - before;
  }

  const SlowClock slow_{0.005};  // the work between two looks at the clock takes longer than a piece should
  Session session_{one_ball()};
  State last_;
};

TEST_F(SlowSteps, SeekingToAFarFrameTakesTurns) {
  ASSERT_EQ(session_.state().frame, 0);
  EXPECT_LE(steps_of([&] { session_.apply(act::SeekEnd{}); }), kMaxSteps);
  int turns = 0;
  for (; session_.state().frame < kFrames && turns < kFrames; ++turns)
    EXPECT_LE(steps_of([&] { session_.advance(0); }), kMaxSteps);
  EXPECT_EQ(session_.state(), last_);
  EXPECT_EQ(session_.record().paths.size(), last_.bodies.size());
  EXPECT_EQ(steps_of([&] { session_.advance(0); }), 0);
}

TEST_F(SlowSteps, TheFrameShownMeanwhileIsOfTheBranch) {
  session_.apply(act::SeekEnd{});
  ASSERT_TRUE(timeline().on_the_way());
  const std::int64_t shown = session_.state().frame;
  EXPECT_EQ(session_.state(), timeline().state_at(timeline().current(), shown));
  EXPECT_EQ(timeline().wanted_frame(), kFrames);
  session_.apply(act::StepBack{});
  EXPECT_EQ(timeline().wanted_frame(), kFrames - 1)
      << "one back from the wanted frame, not from the shown one";
  session_.apply(act::Quit{});
  session_.apply(act::AnswerQuestion{act::Answer::discard});
  EXPECT_TRUE(session_.wants_quit());
}

TEST_F(SlowSteps, AComparisonBeginsWithAStep) {
  session_.apply(act::SeekEnd{});
  while (timeline().on_the_way()) session_.advance(0);
  session_.apply(act::CompareVariant{Variant{SolverKind::exact, true}});
  session_.advance(0);
  constexpr int kFollowed = 2;  // one by the action, one before it plays
  EXPECT_LE(session_.debugger().other_end().value_or(0), kMaxSteps + kFollowed);
  while (session_.debugger().is_busy()) session_.advance(0);
  EXPECT_EQ(session_.debugger().other_end(), kFrames);
}

TEST_F(SlowSteps, EarlierFramesAreComputedInTurns) {
  session_.apply(act::SeekEnd{});
  while (timeline().on_the_way()) session_.advance(0);
  EXPECT_TRUE(session_.frame_view().is_first()) << "the others are read later";
  EXPECT_EQ(session_.frame_view().now().state, last_) << "the shown frame is there at once";
  while (session_.debugger().is_busy()) session_.advance(0);
  session_.advance(0);
  while (session_.debugger().is_busy()) session_.advance(0);
  EXPECT_EQ(session_.frame_view().now().state, last_);
  EXPECT_EQ(session_.frame_view().before(3).state.frame, kFrames - 3);
}

TEST_F(SlowSteps, ATrailGrowsInTurns) {
  const auto trail = [&] { return session_.trail(timeline().current(), 1, 0, kFrames).size(); };
  EXPECT_LE(trail(), kMaxSteps + 1u);
  EXPECT_TRUE(session_.is_on_the_way());
  for (int turns = 0; turns < kFrames; ++turns) trail();
  session_.advance(0);
  EXPECT_FALSE(session_.is_on_the_way());
  ASSERT_EQ(trail(), kFrames + 1u);
  EXPECT_EQ(session_.trail(timeline().current(), 1, 0, kFrames).back().frame, kFrames);
}

// Each of these balls takes some tenths of a ms, and more than a turn together.
TEST(SlowBreakpoints, AreJudgedBeforeTheGameGoesOn) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.tile_shapes[2].kind = TileShape::Kind::solid;
  level.map = TileMap(140, 140);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{2});
  Spawn ball;
  ball.position = {40, 40};
  ball.size = {1024, 1024};
  level.spawns.assign(100, ball);
  Session session(level);
  session.apply(act::SetBreakpoint{{.condition = "penetration > 1 && id == 100", .each_frame = true}});
  session.apply(act::Play{});
  session.advance(1.0 / 60);
  for (int turns = 0; turns < 1000 && session.playback().running; ++turns) session.advance(0.5);
  EXPECT_FALSE(session.playback().running);
  EXPECT_EQ(session.state().frame, 1);
  ASSERT_TRUE(session.debugger().stop());
  EXPECT_EQ(session.debugger().stop()->frame, 1);
  EXPECT_EQ(session.debugger().stop()->body, 100);
}

TEST(SlowBreakpoints, AreJudgedAFewBodiesAtATime) {
  const MadeFrames source(std::vector<State>(3, [] {
    std::vector<Body> bodies;
    for (int i = 1; i <= 100; ++i) bodies.push_back(body_at(i, i, 0));
    return state_of(bodies);
  }()));
  Breakpoints breakpoints;
  breakpoints.put({.condition = "x > 90", .each_frame = true});
  ASSERT_TRUE(breakpoints.ready(source, 0, 1));
  breakpoints.begin_frame(source, 1);
  std::optional<Stop> stop;
  int calls = 1;
  while (!breakpoints.judge_more(stop)) {
    EXPECT_TRUE(breakpoints.is_judging(1));
    ++calls;
  }
  EXPECT_EQ(calls, 12) << "91 bodies";
  EXPECT_FALSE(breakpoints.is_judging(1));
  EXPECT_EQ(stop->body, 91);

  breakpoints.begin_frame(source, 2);
  EXPECT_FALSE(breakpoints.judge_more(stop));
  ASSERT_TRUE(breakpoints.ready(source, 0, 1)) << "the user went back meanwhile";
  breakpoints.begin_frame(source, 1);
  while (!breakpoints.judge_more(stop)) EXPECT_TRUE(breakpoints.is_judging(1));
  EXPECT_EQ(stop->frame, 1);
}

}  // namespace talus::session_slow_steps_test
