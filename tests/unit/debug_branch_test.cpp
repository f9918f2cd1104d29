// The debugger on a timeline: the frames of its branches, and running back to where something was true.
#include "debug/branch_frames.h"

#include <gtest/gtest.h>

#include "debug/compare.h"
#include "debug/stop_search.h"
#include "level_text.h"
#include "sim/timeline.h"

namespace talus {
namespace {

// A ball that bounces on a floor, which from frame 60 on has a hole.
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
    StopSearch search({*ArmedBreakpoint::arm(breakpoint)}, from, direction);
    while (!search.advance(frames, 16)) {
    }
    return search.found();
  }

  Level level_;
  Timeline timeline_;
};

TEST_F(BranchFramesTest, AreThoseThatTheTimelineShows) {
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

TEST_F(BranchFramesTest, RunBackToTheLastTimeItWasTrue) {
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

// Playing on from the past makes a branch; the debugger finds where it left the other one.
TEST_F(BranchFramesTest, OfTwoBranchesAreCompared) {
  const Branch old = timeline_.current();
  timeline_.seek(50);
  level_.tuning.article.fall_speed = 1;
  timeline_.edit(level_);
  for (int i = 0; i < 10; ++i) timeline_.step({});
  const BranchFrames a(timeline_.current()), b(old);
  const ComparedFrames compared(a, b);
  EXPECT_EQ(compared.last(), 60);
  StopSearch search({*ArmedBreakpoint::arm({.id = 1, .condition = parting_condition(0)})}, -1,
                    SearchDirection::forwards);
  while (!search.advance(compared, 16)) {
  }
  EXPECT_EQ(search.found(), (Stop{51, 1, 1, 0}));
}

}  // namespace
}  // namespace talus
