// How much work is done between two checks of the clock.
#include "session/run/work_share.h"

#include <gtest/gtest.h>

namespace talus::work_share_test {

TEST(WorkShare, SlowWorkGetsSmallerPiecesThanQuickWork) {
  WorkShare share(16, 0.002);
  EXPECT_EQ(share.count(), 1) << "nobody knows yet how long one takes";
  for (int i = 0; i < 4; ++i) share.note(0);
  EXPECT_EQ(share.count(), 16);
  share.note(1.5);
  EXPECT_EQ(share.count(), 4);
  share.note(1.5);
  share.note(1.5);
  EXPECT_EQ(share.count(), 1) << "no less than one, however slow";
  share.note(0.001);
  EXPECT_EQ(share.count(), 2);
  for (int i = 0; i < 10; ++i) share.note(0);
  EXPECT_EQ(share.count(), 16);
  share.begin_again();
  EXPECT_EQ(share.count(), 1);
}

TEST(WorkShare, ATimerUpdatesTheShare) {
  WorkShare quick(16, 1e9);
  { const TimedPiece piece(quick); }
  EXPECT_EQ(quick.count(), 2);
  WorkShare slow(16, -1);  // any time is too long
  slow.note(-2);
  { const TimedPiece piece(slow); }
  EXPECT_EQ(slow.count(), 1);
}

}  // namespace talus::work_share_test
