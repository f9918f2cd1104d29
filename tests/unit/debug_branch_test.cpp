// The debugger on a timeline: the frames of its branches, and running back to the last frame in which a
// condition held.
#include "debug/branch_frames.h"

#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "debug/breakpoint_search.h"
#include "debug/compare.h"
#include "debug/explain.h"
#include "formats/native/hard_case_file.h"
#include "level_picture.h"
#include "paths.h"
#include "sim/case_input.h"
#include "sim/timeline.h"

namespace talus::debug_branch_test {

// A ball bounces on a floor, which has a hole from frame 60 on.
class BranchFramesTest : public testing::Test {
 protected:
  BranchFramesTest() : level_(level_of({"o..", "...", "...", "...", "###"})), timeline_(level_) {
    for (int i = 0; i < 60; ++i) timeline_.step({.mouse = {i * 1.0, 0}});
    level_.map.set({0, 4}, 0);
    timeline_.edit(level_);
    for (int i = 0; i < 20; ++i) timeline_.step({});
  }
  std::optional<Stop> search(const Breakpoint& breakpoint, std::int64_t from,
                             SearchDirection direction) const {
    const BranchFrames frames(timeline_.current());
    BreakpointSearch search({*ArmedBreakpoint::arm(breakpoint)}, from, direction);
    while (!search.advance(frames, 16)) {
    }
    return search.found();
  }

  Level level_;
  Timeline timeline_;
};

TEST_F(BranchFramesTest, EqualTheFramesOfTheTimeline) {
  const BranchFrames frames(timeline_.current());
  ASSERT_EQ(frames.last(), 80);
  for (const std::int64_t frame : {0, 1, 2, 60, 59, 61, 80, 7}) {
    Frame read;
    read.other = State();
    frames.read(frame, read);
    timeline_.seek(frame);
    EXPECT_EQ(read.state, timeline_.state()) << frame;
    EXPECT_EQ(read.record.paths.size(), timeline_.record().paths.size());
    EXPECT_EQ(read.record.contacts.size(), timeline_.record().contacts.size());
    EXPECT_EQ(read.ground->is_solid({0, 4}), frame < 60) << "the level as it was there";
    EXPECT_EQ(read.input.mouse.x, frame >= 1 && frame <= 60 ? frame - 1 : 0);
    EXPECT_FALSE(read.other);
  }
}

TEST_F(BranchFramesTest, CanBeSearchedBackwards) {
  const Breakpoint landing{.id = 1, .condition = "touches(0, 4)", .body = 1};
  const auto last = search(landing, 80, SearchDirection::backwards);
  ASSERT_TRUE(last);
  EXPECT_GT(last->frame, 30);
  EXPECT_LE(last->frame, 60);
  const auto before = search(landing, last->frame, SearchDirection::backwards);
  ASSERT_TRUE(before);
  EXPECT_EQ(search(landing, before->frame, SearchDirection::forwards), last);
  EXPECT_EQ(search(landing, last->frame, SearchDirection::forwards), std::nullopt);
  const Breakpoint falling{.id = 1, .condition = "bottom > 33", .body = 1};
  EXPECT_GT(search(falling, 0, SearchDirection::forwards)->frame, 60);
}

TEST_F(BranchFramesTest, GrowWithTheBranch) {
  BranchFrames frames(timeline_.current());
  timeline_.step({});
  EXPECT_EQ(frames.last(), 80);
  frames.grow(timeline_.current());
  EXPECT_EQ(frames.last(), 81);
  Frame read;
  frames.read(81, read);
  EXPECT_EQ(read.state, timeline_.state());
}

// Playing on from the past makes a branch. The debugger finds the frame in which it left the other branch.
TEST_F(BranchFramesTest, TwoBranchesAreCompared) {
  const Branch old = timeline_.current();
  timeline_.seek(50);
  level_.tuning.shared.fall_speed = 1;
  timeline_.edit(level_);
  for (int i = 0; i < 10; ++i) timeline_.step({});
  const BranchFrames a(timeline_.current()), b(old);
  const ComparedFrames compared(a, &b);
  EXPECT_EQ(compared.last(), 60);
  BreakpointSearch search({*ArmedBreakpoint::arm({.id = 1, .condition = parting_condition(0)})}, -1,
                          SearchDirection::forwards);
  while (!search.advance(compared, 16)) {
  }
  EXPECT_EQ(search.found(), (Stop{51, 1, 1, 0}));
}

// A hard case that the article fails. The debugger runs back to the frame in which the ball began to sink
// into the slope, explains it, and finds where the exact solver differs.
TEST(DebuggedHardCase, FailingFrameIsFoundBackwardsAndExplained) {
  auto loaded = load_level(source_path("assets/hard_cases/03-step-with-a-slope.talus.json"));
  ASSERT_TRUE(loaded);
  const auto hard = hard_case_of(loaded->level);
  const auto played = [&](SolverKind solver) {
    Level level = loaded->level;
    level.tuning.solver = solver;
    Timeline timeline(level);
    for (std::int64_t i = 1; i <= (*hard)->frames; ++i) timeline.step(case_input((*hard)->input, i));
    return timeline.current();
  };
  const BranchFrames article(played(SolverKind::article)), exact(played(SolverKind::exact));
  BreakpointSearch back({*ArmedBreakpoint::arm({.id = 1, .condition = "penetration > 1"})},
                        article.last() + 1, SearchDirection::backwards);
  while (!back.advance(article, 64)) {
  }
  ASSERT_TRUE(back.found());
  FrameHistory history(1);
  history.go_to(article, back.found()->frame);
  const std::string why = explain_step(history.view(), 1);
  EXPECT_NE(why.find("under its centre the floor of the up-slope at (10, 12)"), std::string::npos) << why;

  const ComparedFrames compared(article, &exact);
  BreakpointSearch parting({*ArmedBreakpoint::arm({.id = 1, .condition = parting_condition(0.01)})}, -1,
                           SearchDirection::forwards);
  while (!parting.advance(compared, 64)) {
  }
  ASSERT_TRUE(parting.found());
  EXPECT_LE(parting.found()->frame, back.found()->frame);
  BreakpointSearch never({*ArmedBreakpoint::arm({.id = 1, .condition = "penetration > 1e-9"})}, -1,
                         SearchDirection::forwards);
  while (!never.advance(exact, 64)) {
  }
  EXPECT_EQ(never.found(), std::nullopt);
}

}  // namespace talus::debug_branch_test
