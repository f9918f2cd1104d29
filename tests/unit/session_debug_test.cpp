// The debugger of a session: stopping, plotting and comparing, all by actions.
#include <gtest/gtest.h>

#include <cmath>

#include "edit/level_settings.h"
#include "session/session.h"

namespace talus::session_debug_test {

// A ball that bounces on a floor in row 16 of 30x17 cells, and a ball that lies on the floor.
Level bouncing_level() {
  Level level;
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 0; x < level.map.width(); ++x) level.map.set({x, 16}, 1);
  for (const Vec2 position : {Vec2{40, 20}, Vec2{80, 120}}) level.spawns.emplace_back().position = position;
  return level;
}

class SessionDebug : public ::testing::Test {
 protected:
  void step(int count) {
    for (int i = 0; i < count; ++i) session.apply(action::StepFrame{});
  }
  std::int64_t frame() const { return session.state().frame; }
  // Lets real time pass until no work is left.
  void settle() {
    for (int i = 0; i < 1000; ++i) {
      session.advance(0);
      if (!session.debugger().is_busy()) return;
    }
    FAIL() << "the debugger is still busy";
  }
  void add_breakpoint(std::string condition, int count = 1) {
    session.apply(action::SetBreakpoint{{.condition = std::move(condition), .body = 1, .count = count}});
  }
  // The frames in which the ball begins to move up.
  std::vector<std::int64_t> bounces(int frames) {
    std::vector<std::int64_t> found;
    Session other(bouncing_level());
    for (int i = 0; i < frames; ++i) {
      const double before = other.state().bodies[0].velocity.y;
      other.apply(action::StepFrame{});
      if (before >= 0 && other.state().bodies[0].velocity.y < 0) found.push_back(other.state().frame);
    }
    return found;
  }

  Session session{bouncing_level()};
};

TEST_F(SessionDebug, PlayingStopsAtABreakpointAndThenContinues) {
  const auto up = bounces(300);
  ASSERT_GE(up.size(), 3u);
  add_breakpoint("vy < 0");
  for (std::size_t i = 0; i < 3; ++i) {
    session.apply(action::Play{});
    for (int k = 0; k < 400 && session.playback().running; ++k) session.advance(1.0 / 60);
    EXPECT_FALSE(session.playback().running);
    EXPECT_EQ(frame(), up[i]);
    ASSERT_TRUE(session.debugger().stop());
    EXPECT_EQ(session.debugger().stop()->frame, up[i]);
  }
}

TEST_F(SessionDebug, RunsBackAndForthBetweenTheSameStops) {
  const auto up = bounces(200);
  ASSERT_GE(up.size(), 2u);
  step(200);
  add_breakpoint("vy < 0");
  for (std::size_t i = up.size(); i-- > 0;) {
    session.apply(action::RunToBreakpoint{SearchDirection::backwards});
    settle();
    EXPECT_EQ(frame(), up[i]);
  }
  session.apply(action::RunToBreakpoint{SearchDirection::backwards});
  settle();
  EXPECT_EQ(frame(), up[0]) << "there is none before: the shown frame stays";
  EXPECT_TRUE(session.debugger().search_failed());
  session.apply(action::RunToBreakpoint{SearchDirection::forwards});
  settle();
  EXPECT_EQ(frame(), up[1]);
}

TEST_F(SessionDebug, SearchingForwardsPlaysOnPastTheRecording) {
  const auto up = bounces(200);
  add_breakpoint("vy < 0");
  step(2);
  session.apply(action::RunToBreakpoint{SearchDirection::forwards});
  for (int k = 0;
       k < 400 && (session.debugger().searching() || session.playback().running || frame() < up[0]); ++k)
    session.advance(1.0 / 60);
  EXPECT_EQ(frame(), up[0]);
  EXPECT_EQ(session.timeline().last_frame(), up[0]);
}

TEST_F(SessionDebug, HitsAreEqualDuringPlayAndSearch) {
  const auto up = bounces(300);
  ASSERT_GE(up.size(), 3u);
  add_breakpoint("vy < 0", 2);
  session.apply(action::Play{});
  for (int k = 0; k < 400 && session.playback().running; ++k) session.advance(1.0 / 60);
  EXPECT_EQ(frame(), up[1]);
  EXPECT_EQ(session.debugger().breakpoints().hits(1, frame()), 2);
  step(1);
  session.apply(action::SeekFrame{1});
  session.apply(action::RunToBreakpoint{SearchDirection::forwards});
  settle();
  EXPECT_EQ(frame(), up[1]);
}

TEST_F(SessionDebug, AStopIsReportedAndItsBodyChosenIfNoneIs) {
  const auto up = bounces(200);
  add_breakpoint("vy < 0");
  session.apply(action::Play{});
  for (int k = 0; k < 400 && session.playback().running; ++k) session.advance(1.0 / 60);
  const std::string told = "Breakpoint 1 at frame " + std::to_string(up[0]) + ", body 1";
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text, told + ", hit 1.");
  EXPECT_FALSE(session.message()->is_error);
  EXPECT_EQ(session.choices().body, 1);
  step(3);
  session.apply(
      {action::SelectBody{2}, action::DismissMessage{}, action::RunToBreakpoint{SearchDirection::backwards}});
  settle();
  EXPECT_EQ(frame(), up[0]);
  EXPECT_EQ(session.message()->text, told + ".");
  EXPECT_EQ(session.choices().body, 2) << "the user's choice stays";
  session.apply(action::RunToBreakpoint{SearchDirection::backwards});
  settle();
  EXPECT_EQ(session.message()->text, "No breakpoint stops before this frame.");
}

// The list of breakpoints shows the hits up to the shown frame, whichever frame that is.
TEST_F(SessionDebug, HitsAreThoseUpToTheShownFrame) {
  const auto up = bounces(200);
  ASSERT_GE(up.size(), 2u);
  step(200);
  add_breakpoint("vy < 0");
  const auto hits = [&] { return session.debugger().breakpoints().hits(1, frame()); };
  EXPECT_EQ(hits(), std::nullopt) << "nothing is counted in the frame that adds it";
  settle();
  EXPECT_EQ(hits(), static_cast<int>(up.size()));
  for (const auto& [at, expected] : {std::pair(std::int64_t{0}, 0), std::pair(up[0] - 1, 0),
                                     std::pair(up[0], 1), std::pair(up[1], 2), std::pair(up[0], 1)}) {
    session.apply(action::SeekFrame{at});
    EXPECT_EQ(hits(), expected) << at << ": what was counted once is known without counting again";
  }
  session.apply(action::RunToBreakpoint{SearchDirection::forwards});
  settle();
  EXPECT_EQ(frame(), up[1]);
  EXPECT_EQ(hits(), 2);
}

TEST_F(SessionDebug, HitsOfAnotherBranchAreItsOwn) {
  const auto up = bounces(200);
  add_breakpoint("vy < 0");
  step(static_cast<int>(up[0]) + 1);
  settle();
  EXPECT_EQ(session.debugger().breakpoints().hits(1, frame()), 1);
  session.apply(action::ResetPlay{});
  step(1);
  settle();
  EXPECT_EQ(session.debugger().breakpoints().hits(1, frame()), 0);
}

// The first frame in which the sides of a comparison differ is found for a solver as for a branch.
TEST_F(SessionDebug, FindsTheFirstDifferenceAndHowFarAVariantRan) {
  step(150);
  EXPECT_EQ(session.debugger().parting_frame(session.timeline()), std::nullopt);
  session.apply({action::SetParting{0}, action::CompareVariant{Variant{SolverKind::exact, true}}});
  EXPECT_EQ(session.debugger().comparing_progress(session.timeline()), 1.0 / 150)
      << "one step first, as its time is not known yet";
  settle();
  EXPECT_EQ(session.debugger().comparing_progress(session.timeline()), std::nullopt);
  EXPECT_EQ(session.debugger().other_end(), 150);
  const auto parting = session.debugger().parting_frame(session.timeline());
  ASSERT_TRUE(parting);
  session.apply(action::FindParting{session.debugger().parting()});
  settle();
  EXPECT_EQ(frame(), *parting);
  session.apply(action::SetParting{1e9});
  settle();
  EXPECT_EQ(session.debugger().parting_frame(session.timeline()), std::nullopt) << "never so far";
  session.apply(action::SetParting{-1});
  EXPECT_EQ(session.debugger().parting(), 0);
}

TEST_F(SessionDebug, AComparisonReusesFramesThatItHasRun) {
  step(100);
  session.apply(action::CompareVariant{Variant{SolverKind::article, false}});
  settle();
  const Timeline& other = *session.debugger().side_by_side().variant()->timeline();
  ASSERT_EQ(other.current().run_frame(), 100);
  const std::int64_t before = other.steps_again();
  for (int i = 0; i < 10; ++i) {
    session.advance(0);
    session.apply(action::SelectBody{i % 2});
  }
  EXPECT_EQ(other.steps_again(), before);
  step(1);
  settle();
  const std::int64_t to_its_end = other.steps_again();
  step(5);
  EXPECT_EQ(other.current().run_frame(), 106);
  EXPECT_EQ(other.steps_again(), to_its_end);
}

TEST_F(SessionDebug, AWrongOrDisabledBreakpointStopsNothing) {
  add_breakpoint("no such name");
  session.apply(action::SetBreakpoint{{.condition = "vy < 0", .enabled = false}});
  session.apply(action::Play{});
  for (int k = 0; k < 200; ++k) session.advance(1.0 / 60);
  EXPECT_TRUE(session.playback().running);
  EXPECT_FALSE(session.debugger().stop());
}

TEST_F(SessionDebug, PlotsHaveANumberForEachFrame) {
  session.apply(action::SelectBody{1});
  session.apply(action::SetPlot{0, {"body.vy * 2", 0}});
  session.apply(action::SetPlot{1, {"vy +", 0}});
  step(20);
  settle();
  const PlotList& plots = session.debugger().plots();
  ASSERT_EQ(plots.all().size(), 2u);
  EXPECT_FALSE(plots.all()[1].expression);
  EXPECT_EQ(plots.series(plots.all()[1]), nullptr);
  const Series* series = plots.series(plots.all()[0]);
  ASSERT_NE(series, nullptr);
  EXPECT_EQ(series->frames(), 21);
  EXPECT_EQ(series->points().back().last, session.state().bodies[0].velocity.y * 2);
  EXPECT_EQ(PlotList::value(plots.all()[0], session.frame_view(), 1),
            session.state().bodies[0].velocity.y * 2);
  session.apply(action::SelectBody{2});
  settle();
  EXPECT_EQ(plots.series(plots.all()[0])->points().back().last, session.state().bodies[1].velocity.y * 2);
  session.apply(action::RemovePlot{0});
  EXPECT_EQ(plots.all().size(), 1u);
}

TEST_F(SessionDebug, TheOtherSideHasTheSameInputAndAnotherSolver) {
  step(30);
  session.apply(action::CompareVariant{Variant{SolverKind::bump, false}});
  settle();
  ASSERT_NE(session.other_state(), nullptr);
  Level bump = bouncing_level();
  bump.tuning.solver = SolverKind::bump;
  Session other(bump);
  for (int i = 0; i < 30; ++i) other.apply(action::StepFrame{});
  EXPECT_EQ(session.other_state()->bodies, other.state().bodies);
  step(3);
  settle();
  for (int i = 0; i < 3; ++i) other.apply(action::StepFrame{});
  ASSERT_NE(session.other_state(), nullptr);
  EXPECT_EQ(session.other_state()->bodies, other.state().bodies);
  session.apply(action::CompareVariant{});
  settle();
  EXPECT_EQ(session.other_state(), nullptr);
}

TEST_F(SessionDebug, SinglePrecisionDiffersFromTheFoundFrameOn) {
  step(60);
  session.apply(action::CompareVariant{Variant{SolverKind::exact, true}});
  settle();
  session.apply(action::FindParting{1e-9});
  settle();
  const std::int64_t parting = frame();
  const auto apart = [&] {
    double most = 0;
    for (const BodyDifference& body : differences(session.state(), *session.other_state()))
      most = std::max(most, body.distance);
    return most;
  };
  ASSERT_TRUE(session.debugger().stop());
  EXPECT_GT(apart(), 1e-9);
  session.apply(action::StepBack{});
  settle();
  EXPECT_EQ(frame(), parting - 1);
  EXPECT_LE(apart(), 1e-9);
}

TEST_F(SessionDebug, StagesDescribeTheRepeatedStep) {
  for (const auto& [solver, is_single] :
       {std::pair(SolverKind::article, false), std::pair(SolverKind::exact, false),
        std::pair(SolverKind::exact, true)}) {
    Level level = bouncing_level();
    level.tuning.solver = solver;
    level.tuning.exact.single_precision = is_single;
    Session run(level);
    run.apply(action::SelectBody{2});
    for (int i = 0; i < 5; ++i) {
      run.apply(action::StepFrame{});
      const std::vector<Stage> stages = run.stages(), again = stages_of(run.frame_view().now(), 2);
      ASSERT_EQ(stages.size(), again.size());
      EXPECT_GE(stages.size(), 2u);
      for (std::size_t k = 0; k < stages.size(); ++k) {
        EXPECT_EQ(stages[k].sentence, again[k].sentence);
        EXPECT_EQ(stages[k].box, again[k].box);
        EXPECT_EQ(stages[k].cells, again[k].cells);
      }
    }
    run.apply(action::SelectBody{1});
    ASSERT_FALSE(run.stages().empty());
    EXPECT_EQ(run.stages().front().box, stages_of(run.frame_view().now(), 1).front().box);
  }
}

TEST_F(SessionDebug, BreakpointsAndPlotsContinueAfterTheOtherSide) {
  step(3);
  session.apply(action::SeekFrame{1});
  session.apply(action::TakeOver{});
  step(1);
  session.apply(action::CompareBranch{1});  // of 3 frames
  session.apply(action::SelectBody{1});
  session.apply(action::SetPlot{0, {"y", 0}});
  const auto up = bounces(100);
  ASSERT_FALSE(up.empty());
  add_breakpoint("vy < 0");
  session.apply(action::Play{});
  for (int k = 0; k < 400 && session.playback().running; ++k) session.advance(1.0 / 60);
  EXPECT_EQ(frame(), up[0]);
  settle();
  EXPECT_EQ(session.other_state(), nullptr);
  const PlotList& plots = session.debugger().plots();
  EXPECT_EQ(plots.series(plots.all()[0])->frames(), up[0] + 1);
}

TEST_F(SessionDebug, AnEditedLevelIsComparedWithTheOldBranch) {
  step(60);
  session.apply(action::SetEditRule{{EditRule::Kind::from_start, 0}});
  Tuning tuning = session.level().tuning;
  tuning.shared.floor_bounce = 0;
  session.apply(action::EditLevel{set_tuning(session.level(), tuning)});
  for (int k = 0; k < 100 && session.timeline().behind(); ++k) session.advance(1.0 / 60);
  settle();
  ASSERT_NE(session.timeline().compared(), nullptr);
  ASSERT_TRUE(session.timeline().parting_frame());
  const std::int64_t parting = *session.timeline().parting_frame();
  session.apply(action::SeekFrame{parting - 1});
  settle();
  ASSERT_NE(session.other_state(), nullptr);
  EXPECT_EQ(session.other_state()->bodies, session.state().bodies);
  session.apply(action::SeekFrame{parting});
  settle();
  EXPECT_NE(session.other_state()->bodies, session.state().bodies);
}

TEST_F(SessionDebug, StepTimesHaveANumberForEachStepMade) {
  EXPECT_EQ(session.step_times().series(), nullptr);
  step(5);
  ASSERT_NE(session.step_times().series(), nullptr);
  EXPECT_EQ(session.step_times().series()->frames(), 6);
  EXPECT_TRUE(std::isnan(session.step_times().series()->points()[0].last));
  EXPECT_GT(session.step_times().series()->points()[5].last, 0);
}

}  // namespace talus::session_debug_test
