// The level that belongs to a shown frame of a recording.
#include "panels/canvas/level_at_frame.h"
#include "edit/map_stroke.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ball_room.h"
#include "edit/layer_tools.h"
#include "edit/level_settings.h"

namespace talus::level_at_frame_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class LevelOfAFrame : public testing::Test {
 protected:
  void steps(int count) {
    for (int i = 0; i < count; ++i) session_.apply(action::StepFrame{});
  }
  void paint(Cell cell, TileNumber tile = kRoomSolid) {
    session_.apply(action::EditLevel{paint_stamp(session_.level(), cell, {1, 1, {tile}})});
  }
  void show() { level_at_frame_.show(session_, session_.timeline().current(), session_.timeline().frame()); }
  TileNumber tile_at(Cell cell) { return level_at_frame_.level(session_).map.tile_at(cell); }

  Session session_{ball_room()};
  LevelAtFrame level_at_frame_;
};

TEST_F(LevelOfAFrame, IsTheLevelBeforeLaterStrokes) {
  steps(10);
  paint({5, 3});
  paint({6, 4});
  steps(10);
  show();
  EXPECT_FALSE(level_at_frame_.is_other());
  EXPECT_EQ(&level_at_frame_.level(session_), &session_.level()) << "no copy";
  session_.apply(action::SeekFrame{9});
  show();
  ASSERT_TRUE(level_at_frame_.is_other());
  EXPECT_EQ(tile_at({5, 3}), 0);
  EXPECT_THAT(level_at_frame_.changed(), ElementsAre(Cell{5, 3}, Cell{6, 4}));
  EXPECT_EQ(level_at_frame_.caption(),
            "Level as it was at this frame (other: 2 cells); edits go to the newest");
  EXPECT_EQ(session_.level().map.at({5, 3}), kRoomSolid) << "what is edited stays the newest";
  session_.apply(action::SeekFrame{10});
  show();
  EXPECT_FALSE(level_at_frame_.is_other()) << "from that frame on the level is the newest";
}

TEST_F(LevelOfAFrame, OnAnOlderBranchIsTheLevelOfThatBranch) {
  steps(10);
  const int old = session_.timeline().current().id;
  session_.apply({action::SetEditRule{{.kind = EditRule::Kind::from_start}}});
  paint({2, 5});
  session_.apply(action::SwitchBranch{old});
  show();
  ASSERT_TRUE(level_at_frame_.is_other());
  EXPECT_EQ(tile_at({2, 5}), 0);
}

TEST_F(LevelOfAFrame, IsCopiedAgainOnlyAfterAChange) {
  steps(10);
  paint({5, 3});
  steps(10);
  session_.apply(action::SeekFrame{4});
  show();
  const std::uint64_t number = level_at_frame_.number();
  const Level* copy = &level_at_frame_.level(session_);
  for (int frame = 0; frame < 9; ++frame) {
    session_.apply(action::SeekFrame{frame});
    show();
    EXPECT_EQ(level_at_frame_.number(), number) << frame;
    EXPECT_EQ(&level_at_frame_.level(session_), copy);
  }
}

TEST_F(LevelOfAFrame, ReportsOtherDifferences) {
  steps(10);
  Tuning tuning = session_.level().tuning;
  tuning.shared.fall_speed = 3;
  session_.apply(action::EditLevel{set_tuning(session_.level(), tuning)});
  steps(1);
  session_.apply(action::SeekStart{});
  show();
  EXPECT_TRUE(level_at_frame_.is_other());
  EXPECT_THAT(level_at_frame_.changed(), IsEmpty());
  EXPECT_EQ(level_at_frame_.caption(),
            "Level as it was at this frame (other: tuning); edits go to the newest");
}

TEST_F(LevelOfAFrame, AfterAnUndoneStrokeIsTheLevelOfTheSession) {
  steps(10);
  paint({5, 3});
  steps(5);
  session_.apply(action::Undo{});
  steps(5);
  session_.apply(action::SeekStart{});
  show();
  EXPECT_FALSE(level_at_frame_.is_other());
  session_.apply(action::SeekFrame{12});
  show();
  EXPECT_EQ(tile_at({5, 3}), kRoomSolid);
}

TEST_F(LevelOfAFrame, ComparesTheCellsOfAllLayers) {
  session_.apply(action::EditLevel{add_layer(session_.level())});
  steps(10);
  paint({5, 3});
  session_.apply(action::ChooseLayer{0});
  paint({6, 4});
  steps(10);
  session_.apply(action::SeekFrame{9});
  show();
  ASSERT_TRUE(level_at_frame_.is_other());
  EXPECT_THAT(level_at_frame_.changed(), ElementsAre(Cell{5, 3}, Cell{6, 4}));
}

TEST_F(LevelOfAFrame, HasTheLooksThatLayersHaveNow) {
  steps(10);
  paint({5, 3});
  TileLayer looks = session_.level().layers.list[0];
  looks.opacity = 0.5;
  session_.apply(action::EditLevel{set_layer_looks(session_.level(), 0, looks)});
  steps(10);
  session_.apply(action::SeekFrame{9});
  show();
  ASSERT_TRUE(level_at_frame_.is_other());
  EXPECT_EQ(level_at_frame_.level(session_).layers.list[0].opacity, 0.5);
}

TEST_F(LevelOfAFrame, ReportsAnotherNumberOfLayers) {
  steps(10);
  session_.apply(action::EditLevel{add_layer(session_.level())});
  steps(10);
  session_.apply(action::SeekFrame{9});
  show();
  EXPECT_EQ(level_at_frame_.caption(),
            "Level as it was at this frame (other: layers); edits go to the newest");
}

}  // namespace talus::level_at_frame_test
