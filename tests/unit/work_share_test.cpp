// How much work is done between two looks at the clock.
#include "session/work_share.h"

#include <gtest/gtest.h>

namespace talus::work_share_test {

TEST(WorkShare, SlowWorkIsDoneInSmallerPiecesAndQuickWorkInLarger) {
  WorkShare share(16, 0.002);
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
}

TEST(WorkShare, ATimedPieceNotesItself) {
  WorkShare share(16, -1);  // whatever it takes is too long
  { const TimedPiece piece(share); }
  EXPECT_EQ(share.count(), 4);
}

}  // namespace talus::work_share_test
