// The shape of a tile: dragged over its pixels, suggested, copied and given to many tiles.
#include <imgui_internal.h>

#include "harness.h"

namespace talus::shape_ui_test {

class UiShape : public UiTest {
 protected:
  using Kind = TileShape::Kind;

  void SetUp() override {
    UiTest::SetUp();
    Level opened = test_level();
    for (int y = 0; y < 8; ++y)  // tile 7 gets the pixels of an up-slope
      for (int x = 7 - y; x < 8; ++x)
        opened.sheet(SheetId::tiles).images[7][static_cast<std::size_t>(y * 8 + x)] = 6;
    const std::string file = path("shapes.talus.json");
    ASSERT_TRUE(save_level(opened, *format_for_file(file), file));
    start(file);
    click("tabs/shape");
    frames(2);
  }
  const TileShape& shape(int tile) { return level().tile_shapes[static_cast<std::size_t>(tile)]; }
  float zoom() {  // screen px for each px of a tile that is one tile wide
    const bool is_profile = find("shape/handle2") != nullptr;
    return (centre("shape/handle1").x - centre("shape/handle0").x) / (is_profile ? 1 : 8);
  }
  void type_number(const std::string& field, const std::string& number) {  // for tile 9
    click(on_sheet(9));  // so that no earlier click is part of the double click
    click(field);
    click(field);  // a double click lets one type
    key(ctrl('a'));
    type(number);
    key(kKeyTab);
    frames(2);
  }
};

TEST_F(UiShape, EndsOfASlopeAreDraggedToWholePixels) {
  click(on_sheet(9));
  click("shape/kind");
  click("shape/kind_slope");
  EXPECT_EQ(shape(9), (TileShape{.kind = Kind::slope, .heights = {0, 8}}));
  frames(2);
  const ImVec2 left = centre("shape/handle0"), right = centre("shape/handle1");
  drag(left, {left.x, left.y - 3.2f * zoom()});
  EXPECT_EQ(shape(9).heights, (std::vector<double>{3, 8}));
  hold_modifiers(alt(kNoKey));
  drag(right, {right.x, right.y + 2.6f * zoom()});
  hold_modifiers();
  EXPECT_EQ(shape(9).heights, (std::vector<double>{3, 5.5})) << "with Alt, halves";
  EXPECT_EQ(session().history().edits().size(), 3u) << "a drag is one undo";
  click("shape/kind_ceiling");
  EXPECT_EQ(shape(9).side, TileShape::Side::ceiling);
  click("shape/kind_one_way");
  EXPECT_TRUE(shape(9).one_way);
}

TEST_F(UiShape, TheFirstOwnShapeIsTheOneOfTheFlags) {
  click(on_sheet(3));
  click("shape/kind");
  click("shape/kind_slope");
  EXPECT_EQ(shape(3), (TileShape{.kind = Kind::slope, .tiles = 2, .heights = {0, 8}}));
  click("shape/kind");
  click("shape/kind_none");
  EXPECT_EQ(shape(3), TileShape());
}

TEST_F(UiShape, CanvasStandsStillUnderAHeldMouse) {
  click(on_sheet(3));
  frames(2);
  const ImVec2 left = centre("shape/handle0"), right = centre("shape/handle1");
  const float px = (right.x - left.x) / 16;
  move(left);
  press();
  for (const float up : {1.0f, 2.0f, 3.0f}) {
    move({left.x, left.y - up * px});
    frames(2);
    EXPECT_NEAR(centre("shape/handle0").y, left.y - up * px, 1);
    EXPECT_EQ(centre("shape/handle1").y, right.y) << "the tile has a shape of its own from the first px on";
  }
  release();
  EXPECT_EQ(shape(3), (TileShape{.kind = Kind::slope, .tiles = 2, .heights = {3, 8}}));
}

TEST_F(UiShape, LineIsMovedBesideItsHandles) {
  click(on_sheet(9));
  click("shape/kind");
  click("shape/kind_slope");
  frames(2);
  const ImVec2 left = centre("shape/handle0"), right = centre("shape/handle1");
  drag(right, {right.x, right.y + 5 * zoom()});
  ASSERT_EQ(shape(9).heights, (std::vector<double>{0, 3}));
  const std::size_t edits = session().history().edits().size();
  const ImVec2 middle{(left.x + right.x) / 2, left.y - 6 * zoom()};
  click(middle);
  click(ImVec2{left.x + 4, left.y - 4});  // on the handle, beside its middle
  EXPECT_EQ(shape(9).heights, (std::vector<double>{0, 3}));
  EXPECT_EQ(session().history().edits().size(), edits) << "a click changes nothing";
  drag(middle, {middle.x, middle.y - 2 * zoom()});
  EXPECT_EQ(shape(9).heights, (std::vector<double>{2, 5}));
  drag(middle, {middle.x, middle.y - 20 * zoom()});
  EXPECT_EQ(shape(9).heights, (std::vector<double>{5, 8})) << "it keeps its rise at the top, too";
}

TEST_F(UiShape, EscapeCancelsADrag) {
  click(on_sheet(3));
  frames(2);
  const ImVec2 left = centre("shape/handle0");
  move(left);
  press();
  move({left.x, left.y - 40});
  frames(2);
  ASSERT_GT(shape(3).heights.at(0), 0);
  key(kKeyEscape);
  EXPECT_EQ(shape(3), TileShape()) << "the shape comes from the flags again";
  move({left.x, left.y - 60});
  release();
  frames(2);
  EXPECT_EQ(shape(3), TileShape()) << "the drag has ended";
  EXPECT_EQ(session().history().position(), 0u);
}

TEST_F(UiShape, SuggestingTwiceEditsOnce) {
  click(on_sheet(7));
  const ImVec2 button = centre("shape/suggest");
  click(button);
  click(button);
  frames(2);
  EXPECT_EQ(centre("shape/suggest").y, button.y);
  EXPECT_EQ(shape(7), (TileShape{.kind = Kind::slope, .heights = {0, 8}}));
  EXPECT_EQ(session().history().edits().size(), 1u);
}

TEST_F(UiShape, TheProfileOfASolidTileHasFullHeight) {
  click(on_sheet(1));
  click("shape/kind");
  click("shape/kind_profile");
  EXPECT_EQ(shape(1), (TileShape{.kind = Kind::profile, .heights = std::vector<double>(9, 8)}));
}

TEST_F(UiShape, ProfileIsDrawnOverItsColumns) {
  click(on_sheet(9));
  click("shape/kind");
  click("shape/kind_slope");
  frames(2);
  const ImVec2 left = centre("shape/handle0");
  const float px = zoom();
  click("shape/kind");
  click("shape/kind_profile");
  frames(2);
  ASSERT_NE(find("shape/handle8"), nullptr) << "one for each column line";
  const ImVec2 base = centre("shape/handle0");
  EXPECT_NEAR(base.x, left.x, 1);
  // The mouse draws beside the handles, over three columns at a height of 6.
  drag({base.x + 0.1f * px, base.y - 6 * px}, {base.x + 2 * px, base.y - 6 * px});
  EXPECT_EQ(shape(9).heights, (std::vector<double>{6, 6, 6, 3, 4, 5, 6, 7, 8}));
  const ImVec2 fifth = centre("shape/handle4");
  drag(fifth, {fifth.x + 2 * px, fifth.y - 3 * px});
  EXPECT_EQ(shape(9).heights, (std::vector<double>{6, 6, 6, 3, 7, 5, 6, 7, 8})) << "a held one stays itself";
}

TEST_F(UiShape, AShapeIsSuggestedForAllSelectedTiles) {
  click(on_sheet(7));
  click("shape/suggest");
  EXPECT_EQ(shape(7), (TileShape{.kind = Kind::slope, .heights = {0, 8}}));
  key(ctrl('z'));
  drag(on_sheet(1), on_sheet(7));
  click("shape/suggest");
  EXPECT_EQ(shape(1), TileShape{.kind = Kind::solid});
  EXPECT_EQ(shape(7), (TileShape{.kind = Kind::slope, .heights = {0, 8}}));
  EXPECT_EQ(session().history().edits().size(), 1u);
  click(on_sheet(30));
  click("shape/suggest");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Nothing to suggest: all pixels of the tile have colour 0.");
}

TEST_F(UiShape, AChangeIsMadeInAllSelectedTiles) {
  drag(on_sheet(40), on_sheet(41));
  click("shape/kind");
  click("shape/kind_slope");
  frames(2);
  click("shape/kind_one_way");
  const ImVec2 left = centre("shape/handle0");
  drag(left, {left.x, left.y - 3 * zoom()});
  for (const int tile : {40, 41})
    EXPECT_EQ(shape(tile), (TileShape{.kind = Kind::slope, .one_way = true, .heights = {3, 8}})) << tile;
  EXPECT_EQ(session().history().edits().size(), 3u);
}

TEST_F(UiShape, AShapeIsCopiedToAllSelectedTiles) {
  click(on_sheet(7));
  click("shape/suggest");
  drag(on_sheet(7), on_sheet(24));
  click("shape/give");
  for (const int tile : {7, 8, 23, 24})
    EXPECT_EQ(shape(tile), (TileShape{.kind = Kind::slope, .heights = {0, 8}})) << tile;
  key(ctrl('z'));
  EXPECT_EQ(shape(24), TileShape());
  EXPECT_EQ(shape(7).kind, Kind::slope);
}

TEST_F(UiShape, MirroredCopyGoesToTheNextFreeTileWithItsPixels) {
  click(on_sheet(7));
  click("shape/suggest");
  frames(2);
  click("shape/copy");
  EXPECT_EQ(shape(8), (TileShape{.kind = Kind::slope, .heights = {8, 0}}));
  EXPECT_EQ(level().sheet(SheetId::tiles).images[8][0], 6);
  EXPECT_EQ(level().sheet(SheetId::tiles).images[8][7], 0);
  EXPECT_EQ(session().history().edits().size(), 2u);
  click("shape/turn");
  click("shape/turn2");
  frames(2);
  click("shape/copy");
  EXPECT_EQ(shape(9), (TileShape{.kind = Kind::slope, .side = TileShape::Side::ceiling, .heights = {0, 8}}));
}

TEST_F(UiShape, CopyOverUsedTilesSaysSoFirst) {
  click(on_sheet(3));
  frames(2);
  const float free_width = find("shape/copy")->max.x - find("shape/copy")->min.x;
  const auto type_target = [&](const std::string& number) {
    click("shape/target");
    key(ctrl('a'));
    type(number);
    key(kKeyEnter);
    frames(2);
  };
  type_target("256");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "There is no tile 256: tiles have the numbers 0 to 255.");
  type_target("1");
  EXPECT_GT(find("shape/copy")->max.x - find("shape/copy")->min.x, free_width) << "it is called Replace";
  EXPECT_EQ(shape(1), TileShape());
  click("shape/copy");
  EXPECT_EQ(shape(1), (TileShape{.kind = Kind::slope, .tiles = 2, .heights = {8, 0}}));
}

TEST_F(UiShape, InvalidNumbersAreRefused) {
  click(on_sheet(9));
  click("shape/kind");
  click("shape/kind_profile");
  frames(2);
  const TileShape before = shape(9);
  type_number("shape/kind_height2", "99");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Not changed: a height must be 0 to 64 px.");
  type_number("shape/kind_tiles", "9");
  EXPECT_EQ(session().message()->text, "Not changed: a width must be 1 to 8 tiles.");
  type_number("shape/kind_tiles", "1.5");
  EXPECT_EQ(session().message()->text, "Not changed: a width must be whole tiles.");
  EXPECT_EQ(shape(9), before);
  EXPECT_EQ(session().history().edits().size(), 1u);
  type_number("shape/kind_height2", "64");
  EXPECT_EQ(shape(9).heights[2], 64);
  EXPECT_GE(zoom(), 4) << "a shape as high as may be is still large enough for the hand";
}

TEST_F(UiShape, FieldsOfHeightsHaveRoomForTheirNumbers) {
  click(on_sheet(9));
  click("shape/kind");
  click("shape/kind_profile");
  frames(2);
  const auto width = [&] { return find("shape/kind_height2")->max.x - find("shape/kind_height2")->min.x; };
  const float before = width();
  type_number("shape/kind_height2", "15.142857");
  EXPECT_EQ(shape(9).heights[2], 15.142857);
  EXPECT_GT(width(), before);
}

TEST_F(UiShape, NothingCoversTheCanvasAfterADrag) {
  click(on_sheet(3));
  frames(2);
  const ImVec2 left = centre("shape/handle0");
  drag(left, {left.x, left.y - 40});
  frames(60);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  EXPECT_TRUE(tooltip == nullptr || !tooltip->Active);
}

TEST_F(UiShape, TheRightHalfOfARampShowsTheWholeRamp) {
  click(on_sheet(4));
  frames(2);
  ASSERT_NE(find("shape/handle1"), nullptr);
  const ImVec2 left = centre("shape/handle0"), right = centre("shape/handle1");
  drag(left, {left.x, left.y - (right.x - left.x) / 16});
  EXPECT_EQ(shape(3).heights, (std::vector<double>{1, 8})) << "what is shown is tile 3's";
  EXPECT_EQ(shape(4), TileShape());
  click("shape/owner");
  frames(2);
  EXPECT_EQ(session().choices().area, (SpriteArea{SheetId::tiles, {3, 0, 1, 1}}));
  EXPECT_EQ(find("shape/owner"), nullptr);
  EXPECT_NEAR(centre("shape/handle1").y, right.y, 1);
}

TEST_F(UiShape, TheOverlayIsSwitchedForMapAndSheet) {
  EXPECT_FALSE(session().choices().overlays.has(overlay::shapes));
  click("overlay/shapes");
  EXPECT_TRUE(session().choices().overlays.has(overlay::shapes));
}

}  // namespace talus::shape_ui_test
