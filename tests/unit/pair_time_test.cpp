// When two boxes meet that go along parabolas.
#include "sim/meet/pair_time.h"

#include <gtest/gtest.h>

namespace talus::pair_time_test {

MovingBox box(Vec2 place, Vec2 velocity, Vec2 pull = {}) { return {{0, place, velocity, pull}, {8, 8}}; }

TEST(PairTime, BoxesMeetOnTheSideWhereTheyCome) {
  const auto meeting = next_meeting(box({0, 0}, {4, 0}), box({20, 3}, {-2, 0}), 0, 5);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->time, 2);
  EXPECT_EQ(meeting->normal, (Vec2{-1, 0}));
  const auto mirrored = next_meeting(box({20, 3}, {-2, 0}), box({0, 0}, {4, 0}), 0, 5);
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->time, 2);
  EXPECT_EQ(mirrored->normal, (Vec2{1, 0}));
}

TEST(PairTime, BoxesThatPassDoNotMeet) {
  EXPECT_FALSE(next_meeting(box({0, 0}, {4, 0}), box({20, 8}, {-2, 0}), 0, 5));
  EXPECT_FALSE(next_meeting(box({0, 0}, {-4, 0}), box({20, 0}, {2, 0}), 0, 5));
  EXPECT_FALSE(next_meeting(box({0, 0}, {4, 0}), box({20, 0}, {-2, 0}), 0, 2)) << "only later";
}

// One that was thrown up and falls onto one that rests.
TEST(PairTime, AParabolaMeetsOnItsWayDown) {
  const MovingBox thrown = box({0, -8}, {0, -1}, {0, 0.5});
  const auto meeting = next_meeting(thrown, box({0, 0}, {}), 0, 10);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->time, 4);
  EXPECT_EQ(meeting->normal, (Vec2{0, -1}));
}

TEST(PairTime, CornersMeetOnTheUpperSideAndFromBothAxesAlone) {
  const auto meeting = next_meeting(box({0, 0}, {1, 1}), box({10, 10}, {}), 0, 5);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->normal, (Vec2{0, -1}));
  // Along the top of a row of boxes.
  EXPECT_FALSE(next_meeting(box({0, 0}, {1, 0}), box({10, 8}, {}), 0, 5));
}

TEST(PairTime, BoxesThatTouchAndRestDoNotMeet) {
  EXPECT_FALSE(next_meeting(box({0, 0}, {}), box({8, 0}, {}), 0, 1));
  EXPECT_FALSE(next_meeting(box({0, 0}, {}, {0, 0.2}), box({0, 8}, {}, {0, 0.2}), 0, 1)) << "both fall";
  EXPECT_EQ(next_meeting(box({0, 0}, {}, {0, 0.2}), box({0, 8}, {}), 0, 1)->time, 0) << "one is held";
}

TEST(PairTime, OverlappingBoxesTouchWhereTheyOverlapLeast) {
  EXPECT_EQ(touching_normal({{0, 0, 8, 8}}, {{7, 1, 8, 8}}, true), (Vec2{-1, 0}));
  EXPECT_EQ(touching_normal({{0, 0, 8, 8}}, {{1, -7, 8, 8}}, true), (Vec2{0, 1}));
  EXPECT_EQ(touching_normal({{0, 0, 8, 8}}, {{8, 8, 8, 8}}, true), std::nullopt) << "two corners";
  EXPECT_EQ(touching_normal({{0, 0, 8, 8}}, {{0, 0, 8, 8}}, true), (Vec2{0, -1}));
  EXPECT_EQ(touching_normal({{0, 0, 8, 8}}, {{0, 0, 8, 8}}, false), (Vec2{0, 1}));
}

}  // namespace talus::pair_time_test
