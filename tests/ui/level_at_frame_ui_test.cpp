// The play view at earlier frames and on older branches draws the level as it was there.
#include "debugger_harness.h"
#include "edit/map_stroke.h"
#include "platform/picture.h"

namespace talus::level_at_frame_ui_test {

class UiLevelAtFrame : public DebuggerTest {
 protected:
  Rgb color_at(ImVec2 at) {
    move({1, 1});  // elsewhere, as the mouse shows a preview of the tile that it would paint
    frames(2);
    const auto picture = draw_picture();
    if (!picture) {
      ADD_FAILURE() << picture.error();
      return {};
    }
    const auto row = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(picture->width);
    const std::size_t first = (row + static_cast<std::size_t>(at.x)) * 4;
    return {picture->rgba[first], picture->rgba[first + 1], picture->rgba[first + 2]};
  }
  ImVec2 middle_of(const std::string& canvas, Cell cell) {
    return on_canvas(canvas, {cell.x * 8 + 4.0, cell.y * 8 + 4.0});
  }
  Rgb color_in(const std::string& canvas, Cell cell) { return color_at(middle_of(canvas, cell)); }
  void paint(Cell cell, int w = 1, int h = 1) {
    const Stamp solid{w, h, std::vector<MapCell>(static_cast<std::size_t>(w * h), 1)};
    session().apply(action::EditLevel{paint_stamp(level(), cell, solid)});
    frames(2);
  }
};

TEST_F(UiLevelAtFrame, AnEarlierFrameIsShownWithoutLaterStrokes) {
  app().ui().view.canvas.mode = CanvasMode::both;
  const Cell cell{20, 8};
  const Rgb solid = level().palette[13];
  play(10);
  paint(cell);
  play(5);
  EXPECT_EQ(color_in("play", cell), solid);
  key(kKeyEnd);
  session().apply(action::SeekFrame{4});
  EXPECT_NE(color_in("play", cell), solid);
  EXPECT_EQ(color_in("map", cell), solid) << "the map is edited, and so the newest";
  session().apply(action::SeekFrame{10});
  EXPECT_EQ(color_in("play", cell), solid);
}

TEST_F(UiLevelAtFrame, ZoomedOutFramesShowTheirLevelToo) {
  app().ui().view.canvas.mode = CanvasMode::play;
  frames(2);
  play(10);
  paint({8, 2}, 16, 12);
  play(5);
  move(centre("play/canvas"));
  wheel(-8);
  const Cell middle{16, 8};
  const Rgb solid = level().palette[13];
  ASSERT_NEAR(middle_of("play", {17, 8}).x - middle_of("play", middle).x, 2, 0.01) << "px of a cell: far";
  EXPECT_EQ(color_in("play", middle), solid);
  session().apply(action::SeekFrame{4});
  EXPECT_NE(color_in("play", middle), solid);
}

TEST_F(UiLevelAtFrame, TheOtherSideShowsTheLevelOfItsOwnBranch) {
  app().ui().view.canvas.mode = CanvasMode::play;
  const Cell cell{12, 8};
  const Rgb solid = level().palette[13];
  play(10);
  session().apply(action::SetEditRule{{.kind = EditRule::Kind::from_start}});
  paint(cell);
  frames(5);
  ASSERT_NE(timeline().compared(), nullptr);
  app().ui().view.canvas.split_compared = true;
  frames(3);
  ASSERT_NE(find("play/other_side"), nullptr);
  const ImVec2 here = middle_of("play", cell);
  const ImVec2 there{here.x + find("play/other_side")->min.x - find("play/canvas")->min.x, here.y};
  EXPECT_EQ(color_at(here), solid);
  EXPECT_NE(color_at(there), solid);
}

}  // namespace talus::level_at_frame_ui_test
