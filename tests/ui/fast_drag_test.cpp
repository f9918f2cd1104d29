// Fast drags in slow frames: the press, all movements and the release come before one frame.
#include <cmath>

#include "edit/spawn_tools.h"
#include "harness.h"

namespace talus::fast_drag_test {

class UiFastDrag : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start_on_the_map();
  }
  void drag_over_cells(std::initializer_list<Cell> cells, int button = kLeft) {
    std::vector<ImVec2> places;
    for (const Cell cell : cells) places.push_back(on_map(cell));
    push_drag(places, button);
    frames(2);
  }
  void drag_over_pixels(std::initializer_list<Cell> pixels) {
    std::vector<ImVec2> places;
    for (const Cell pixel : pixels) places.push_back(on_pixels(pixel.x, pixel.y));
    push_drag(places);
    frames(2);
  }
  // The cells in columns 0 to 9 and rows 0 to 7 that are not empty.
  std::vector<std::string> drawn() {
    std::vector<std::string> rows(8, std::string(10, '.'));
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 10; ++x)
        if (tile_at({x, y}) != 0) rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
    return rows;
  }
  // The pixels of tile 9 that are not colour 0.
  std::vector<std::string> pixels() {
    std::vector<std::string> rows(8, std::string(8, '.'));
    for (std::size_t i = 0; i < 64; ++i)
      if (level().sheet(SheetId::tiles).images[9][i] != 0) rows[i / 8][i % 8] = '#';
    return rows;
  }
  std::size_t undos() { return session().history().position(); }
};

using Rows = std::vector<std::string>;

const Rows kCorner = {"..........", ".#####....", ".....#....", ".....#....",
                      ".....#....", "..........", "..........", ".........."};

TEST_F(UiFastDrag, StampPaintsAllPlacesInOrder) {
  drag_over_cells({{1, 1}, {5, 1}, {5, 4}});
  EXPECT_EQ(drawn(), kCorner);
  EXPECT_EQ(undos(), 1u);
}

TEST_F(UiFastDrag, SeveralStrokesAreEachWhole) {
  const ImVec2 a = on_map({1, 1}), b = on_map({5, 1}), c = on_map({5, 2}), d = on_map({5, 4});
  push_drag({a, b});
  push_drag({c, d});
  frames(2);
  EXPECT_EQ(drawn(), kCorner);
  EXPECT_EQ(undos(), 2u);
}

TEST_F(UiFastDrag, EraserErasesEveryPlace) {
  drag_over_cells({{1, 1}, {9, 1}});
  key('e');
  drag_over_cells({{2, 1}, {4, 1}, {8, 1}});
  EXPECT_EQ(drawn()[1], ".#.......#");
}

TEST_F(UiFastDrag, LineRectangleAndEllipseReachToTheRelease) {
  key('5');
  drag_over_cells({{0, 0}, {3, 5}, {4, 0}});
  EXPECT_EQ(drawn()[0], "#####.....");
  key('6');
  drag_over_cells({{1, 2}, {2, 3}, {3, 3}});
  EXPECT_EQ(drawn()[2] + drawn()[3], ".###.......###......");
  key('7');
  drag_over_cells({{5, 4}, {7, 5}, {8, 7}});
  EXPECT_EQ(drawn()[4] + drawn()[5], "......##.......####.");
  EXPECT_EQ(drawn()[6] + drawn()[7], ".....####.......##..");
  EXPECT_EQ(undos(), 3u);
}

TEST_F(UiFastDrag, FillStartsAtThePress) {
  drag_over_cells({{2, 0}, {2, 7}});
  drag_over_cells({{0, 7}, {2, 7}});
  key('4');
  drag_over_cells({{1, 1}, {5, 1}, {5, 4}});
  EXPECT_EQ(drawn()[3], "###.......");
  EXPECT_EQ(undos(), 3u);
}

TEST_F(UiFastDrag, MiddleButtonPicksTheWholeRectangle) {
  drag_over_cells({{1, 1}, {3, 1}});
  app().ui().view.preferences.middle_picks = true;
  drag_over_cells({{1, 1}, {2, 2}, {4, 1}}, kMiddle);
  EXPECT_EQ(session().choices().stamp, (Stamp{4, 1, {1, 1, 1, 0}}));
}

TEST_F(UiFastDrag, GroundIsPaintedToTheRelease) {
  key(shift('g'));
  key('g');
  drag_over_cells({{1, 1}, {5, 1}, {5, 4}});
  EXPECT_EQ(drawn(), kCorner);
}

TEST_F(UiFastDrag, SelectionIsMadeAndMovedToTheRelease) {
  drag_over_cells({{1, 1}, {2, 1}});
  key('3');
  drag_over_cells({{1, 1}, {4, 4}, {3, 2}});
  EXPECT_EQ(session().choices().selection, (CellRect{1, 1, 3, 2}));
  drag_over_cells({{2, 1}, {4, 4}, {7, 3}});
  EXPECT_EQ(session().choices().selection, (CellRect{6, 3, 3, 2}));
  EXPECT_EQ(drawn()[1] + drawn()[3], "................##..");
}

TEST_F(UiFastDrag, FlagBrushPaintsToTheRelease) {
  key(ctrl_shift('f'));
  ASSERT_EQ(session().choices().flag_overlay, pattern_of_flag(0));
  std::vector<ImVec2> places;
  for (const int tile : {40, 42, 26}) places.push_back(on_sheet(tile));
  push_drag(places);
  frames(2);
  for (const int tile : {40, 41, 42, 26})
    EXPECT_EQ(level().tile_flags(static_cast<TileNumber>(tile)), 1) << tile;
  EXPECT_EQ(undos(), 1u);
}

TEST_F(UiFastDrag, SlopeAndSegmentEndAtTheRelease) {
  key('8');
  push_drag({on_canvas("map", {16, 40}), on_canvas("map", {40, 60}), on_canvas("map", {32, 32})});
  frames(2);
  EXPECT_NE(tile_at({2, 4}), 0);
  EXPECT_NE(tile_at({3, 4}), 0);
  key('9');
  push_drag({on_canvas("map", {80, 40}), on_canvas("map", {100, 60}), on_canvas("map", {128, 48})});
  frames(2);
  ASSERT_EQ(level().curves.size(), 1u);
  const auto ends = ends_of_curve(level().curves[0].curve);
  EXPECT_EQ(ends.first, (Vec2{80, 40}));
  EXPECT_EQ(ends.second, (Vec2{128, 48}));
}

TEST_F(UiFastDrag, HandleOfACurveGoesToTheRelease) {
  click("map/curve");
  while (session().choices().curve_kind != CurveKind::arc) key('c');
  drag(on_canvas("map", {16, 40}), on_canvas("map", {80, 40}));
  const ImVec2 handle = centre("map/curve_handle2"), on_the_way = on_canvas("map", {60, 30}),
               to = on_canvas("map", {48, 8});
  push_drag({handle, on_the_way, to});
  frames(2);
  EXPECT_EQ(level().curves.at(0).curve, (Curve{Arc{{48, 40}, 32, 16, 80, true}, Curve::Faces::up}));
  EXPECT_EQ(undos(), 2u);
}

TEST_F(UiFastDrag, BodyAndItsArrowGoToTheRelease) {
  click("map/body");
  session().apply(action::EditLevel{add_spawn(level(), Spawn())});
  session().apply(action::SelectSpawn{0});  // the next one is like it, and not asked for
  frames(2);
  push_drag({on_canvas("map", {100, 60}), on_canvas("map", {120, 50}), on_canvas("map", {131, 53})});
  frames(2);
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(level().spawns[1].position, (Vec2{127, 49})) << "placed at (96,56), and taken along";
  const ImVec2 from = centre("map/velocity_handle"), zero = on_canvas("map", {0, 0}),
               by = on_canvas("map", {12, -8});
  push_drag({from, {from.x + 20, from.y + 20}, {from.x + by.x - zero.x, from.y + by.y - zero.y}});
  frames(2);
  EXPECT_EQ(level().spawns[1].velocity, (Vec2{3, -2}));
}

TEST_F(UiFastDrag, PencilDrawsEveryPlaceInOrder) {
  click(on_sheet(9));
  click("palette/color5");
  drag_over_pixels({{1, 1}, {6, 1}, {6, 6}});
  EXPECT_EQ(pixels(), (Rows{"........", ".######.", "......#.", "......#.", "......#.", "......#.",
                            "......#.", "........"}));
  EXPECT_EQ(undos(), 1u);
}

TEST_F(UiFastDrag, ShapesAndSelectionOfPixelsReachToTheRelease) {
  click(on_sheet(9));
  click("palette/color5");
  click("pixels/rectangle");
  drag_over_pixels({{0, 0}, {1, 1}, {7, 2}});
  EXPECT_EQ(pixels()[0] + pixels()[1] + pixels()[2], "#########......#########");
  click("pixels/line");
  drag_over_pixels({{0, 4}, {1, 7}, {7, 4}});
  EXPECT_EQ(pixels()[4], "########");
  click("pixels/ellipse");
  drag_over_pixels({{0, 5}, {1, 6}, {2, 7}});
  EXPECT_EQ(pixels()[5] + pixels()[6] + pixels()[7], "###.....#.#.....###.....");
  click("pixels/select");
  drag_over_pixels({{0, 0}, {5, 5}, {3, 1}});
  EXPECT_EQ(session().choices().pixels.rect(), (CellRect{0, 0, 4, 2}));
  drag_over_pixels({{1, 1}, {5, 5}, {3, 3}});
  EXPECT_EQ(session().choices().pixels.rect(), (CellRect{2, 2, 4, 2}));
}

TEST_F(UiFastDrag, HandleOfAShapeGoesToTheRelease) {
  click(on_sheet(9));
  click("tabs/shape");
  frames(2);
  click("shape/kind");
  click("shape/kind_slope");
  frames(2);
  const ImVec2 left = centre("shape/handle0");
  const float zoom = (centre("shape/handle1").x - left.x) / 8;
  push_drag({left, {left.x, left.y - 6 * zoom}, {left.x, left.y - 3.2f * zoom}});
  frames(2);
  EXPECT_EQ(level().tile_shapes[9].heights, (std::vector<double>{3, 8}));
}

TEST_F(UiFastDrag, SplitterGoesToTheRelease) {
  const ImVec2 from = centre("layout/left");
  push_drag({from, {from.x + 90, from.y}, {from.x + 40, from.y}});
  frames(2);
  EXPECT_NEAR(centre("layout/left").x, from.x + 40, 1);
}

TEST_F(UiFastDrag, ViewMovesByTheDragAlone) {
  const ImVec2 from = on_map({12, 8});
  move(on_map({3, 3}));
  push_drag({from, {from.x - 60, from.y + 30}, {from.x - 20, from.y - 10}}, kRight);
  frames(2);
  const ImVec2 now = on_map({12, 8});
  EXPECT_EQ(std::lround(now.x - from.x), -20);
  EXPECT_EQ(std::lround(now.y - from.y), -10);
}

TEST_F(UiFastDrag, TimelineGoesToTheRelease) {
  session().apply(action::Pause{});
  for (int i = 0; i < 40; ++i) key(kKeyF10);
  ASSERT_EQ(session().timeline().last_frame(), 40);
  const Widget track = *find("timeline/track");
  const float inset = app().ui().px(6), width = track.max.x - track.min.x - 2 * inset;
  const auto on_track = [&](float frame) {
    return ImVec2{track.min.x + inset + width * frame / 40, (track.min.y + track.max.y) / 2 + 3};
  };
  push_drag({on_track(40), on_track(5), on_track(20)});
  frames(2);
  EXPECT_EQ(session().timeline().frame(), 20);
}

// A mouse that reports 1000 places a second, 16 in each frame, on a curve as a hand draws it.
TEST_F(UiFastDrag, SmoothMovementsNeedNoMoreFrames) {
  const ImVec2 from = on_map({3, 3});
  std::vector<ImVec2> places;
  for (int i = 0; i <= 64; ++i) {
    const float turn = static_cast<float>(i) * 0.01f;
    places.push_back({from.x + 100 * std::sin(turn), from.y + 100 - 100 * std::cos(turn)});
  }
  push_drag(places);
  int used = 0;
  for (; used == 0 || app().has_waiting_events(); ++used) app().frame();
  EXPECT_LE(used, 8) << "64 places";
}

// However fast the hand scribbles, the drawing is never far behind.
TEST_F(UiFastDrag, ManyCornersAreSkippedRatherThanDrawnLate) {
  const ImVec2 a = on_map({3, 3}), b = on_map({5, 3}), c = on_map({4, 5});
  std::vector<ImVec2> places;
  for (int i = 0; i < 300; ++i) places.push_back(i % 3 == 0 ? a : i % 3 == 1 ? b : c);
  push_drag(places);
  int used = 0;
  for (; used == 0 || app().has_waiting_events(); ++used) app().frame();
  EXPECT_LE(used, 70);
  EXPECT_NE(tile_at({4, 5}), 0);
}

}  // namespace talus::fast_drag_test
