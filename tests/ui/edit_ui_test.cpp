// Painting, pixels, flags, palette, tuning, and undoing all of it.
#include "edit/flag_lamps.h"
#include "harness.h"
#include "panels/level/edit_text.h"
#include "panels/sprites/tile_number.h"

namespace talus::edit_ui_test {

class UiEdit : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  std::uint8_t pixel(int tile, int x, int y) {
    return level()
        .sheet(SheetId::tiles)
        .images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(y * 8 + x)];
  }
  FlagSet flags(int tile) { return level().sheet(SheetId::tiles).flags[static_cast<std::size_t>(tile)]; }
};

TEST_F(UiEdit, ClickPaintsTheSelectedTile) {
  click(on_sheet(3));
  EXPECT_EQ(session().choices().stamp.tiles, std::vector<MapCell>{3});
  click(on_map({12, 9}));
  EXPECT_EQ(tile_at({12, 9}), 3);
  EXPECT_EQ(tile_at({13, 9}), 0);
  EXPECT_TRUE(session().modified());
}

TEST_F(UiEdit, StrokeIsOneUndo) {
  click(on_sheet(1));
  drag(on_map({3, 4}), on_map({11, 4}));
  for (int x = 3; x <= 11; ++x) EXPECT_EQ(tile_at({x, 4}), 1) << x;
  EXPECT_EQ(session().history().edits().size(), 1u);
  key(ctrl('z'));
  for (int x = 3; x <= 11; ++x) EXPECT_EQ(tile_at({x, 4}), 0) << x;
  EXPECT_FALSE(session().modified());
  key(ctrl('y'));
  EXPECT_EQ(tile_at({11, 4}), 1);
  drag(on_map({3, 6}), on_map({5, 6}));
  EXPECT_EQ(session().history().edits().size(), 2u);
}

TEST_F(UiEdit, StampOfSeveralTiles) {
  drag(on_sheet(3), on_sheet(6));
  EXPECT_EQ(session().choices().stamp.w, 4);
  click(on_map({10, 8}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(tile_at({10 + i, 8}), 3 + i);
}

TEST_F(UiEdit, PickedTilesAreSelectedOnTheSheet) {
  drag(on_sheet(3), on_sheet(6));
  click(on_map({10, 8}));
  click(on_sheet(1));
  key(kKeyF3);
  key('i');
  drag(on_map({11, 8}), on_map({13, 8}));
  EXPECT_EQ(session().choices().stamp.tiles, (std::vector<MapCell>{4, 5, 6}));
  EXPECT_EQ(session().choices().area.tiles, (CellRect{4, 0, 3, 1}));
  key('i');
  drag(on_map({13, 8}), on_map({14, 8}));  // tiles 6 and 0 are apart on the sheet
  EXPECT_EQ(session().choices().stamp.tiles, (std::vector<MapCell>{6, 0}));
  EXPECT_EQ(session().choices().area.tiles, (CellRect{6, 0, 1, 1}));
}

TEST_F(UiEdit, SpritesSheetLeavesTheStamp) {
  click(on_sheet(3));
  click("sheet/show_sprites");
  frames(2);
  click(on_sheet(40));
  EXPECT_EQ(session().choices().area.sheet, SheetId::sprites);
  EXPECT_EQ(session().choices().stamp.tiles, std::vector<MapCell>{3});
  EXPECT_NE(find("status/stamp"), nullptr) << "the picture of what is painted";
  EXPECT_EQ(number_on_screen(SheetId::sprites, 40), 296);
  EXPECT_EQ(number_on_screen(SheetId::tiles, 40), 40);
}

TEST_F(UiEdit, MapToolsByTheirKeys) {
  click(on_sheet(1));
  key(kKeyF3);
  key('6');
  drag(on_map({2, 2}), on_map({4, 3}));
  for (int y = 2; y <= 3; ++y)
    for (int x = 2; x <= 4; ++x) EXPECT_EQ(tile_at({x, y}), 1);
  key('e');
  click(on_map({3, 2}));
  EXPECT_EQ(tile_at({3, 2}), 0);
  key('i');
  drag(on_map({2, 2}), on_map({3, 2}));
  EXPECT_EQ(session().choices().stamp.tiles, (std::vector<MapCell>{1, 0}));
  EXPECT_EQ(session().choices().map_tool, MapTool::stamp);
  key('4');
  click(on_sheet(6));
  click(on_map({20, 2}));
  EXPECT_EQ(tile_at({20, 2}), 6);
  EXPECT_EQ(tile_at({29, 15}), 6);
  EXPECT_EQ(tile_at({2, 2}), 1);
  move(on_map({4, 3}));
  key(kKeyDelete);
  EXPECT_EQ(tile_at({4, 3}), 0);
}

TEST_F(UiEdit, PencilDrawsWithBothButtons) {
  click(on_sheet(1));
  click("palette/color5");
  click("palette/color9", kRight);
  drag(on_pixels(0, 0), on_pixels(7, 0));
  click(on_pixels(3, 5), kRight);
  for (int x = 0; x < 8; ++x) EXPECT_EQ(pixel(1, x, 0), 5) << x;
  EXPECT_EQ(pixel(1, 3, 5), 9);
  EXPECT_EQ(pixel(1, 0, 1), 13);
  key(ctrl('z'));
  EXPECT_EQ(pixel(1, 3, 5), 13);
  key(ctrl('z'));
  EXPECT_EQ(pixel(1, 0, 0), 13);
  EXPECT_EQ(pixel(1, 7, 0), 13);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiEdit, SpriteToolsByTheirKeys) {
  click(on_sheet(2));
  key('4');
  click("palette/color7");
  click(on_pixels(0, 0));
  EXPECT_EQ(pixel(2, 7, 7), 7);
  EXPECT_EQ(pixel(2, 3, 3), 3);
  key('1');
  click("palette/color1");
  click(on_pixels(0, 0));
  key('5');
  EXPECT_EQ(pixel(2, 7, 0), 1);
  EXPECT_EQ(pixel(2, 0, 0), 7);
  key('6');
  EXPECT_EQ(pixel(2, 7, 7), 1);
  key('7');
  EXPECT_EQ(pixel(2, 0, 7), 1);
  key('2');
  click(on_pixels(3, 3));
  EXPECT_EQ(session().choices().color, 3);
  click(on_pixels(0, 0), kMiddle);
  EXPECT_EQ(session().choices().color, 7);
  key(']');
  EXPECT_EQ(session().choices().color, 8);
  key('[');
  EXPECT_EQ(session().choices().color, 7);
  key('8');
  EXPECT_EQ(pixel(2, 3, 3), 0);
  key(kKeyRight);
  EXPECT_EQ(session().choices().area.tiles, (CellRect{3, 0, 1, 1}));
  key(kKeyTab);
  EXPECT_EQ(session().choices().area.sheet, SheetId::sprites);
}

TEST_F(UiEdit, LampTogglesTheFlagOfOneTile) {
  click(on_sheet(7));
  click("flags/lamp3");
  EXPECT_EQ(flags(7), 8);
  click("flags/lamp0");
  EXPECT_EQ(flags(7), 9);
  click("flags/lamp3");
  EXPECT_EQ(flags(7), 1);
  key(ctrl('z'));
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_EQ(flags(7), 0);
  key(ctrl('y'));
  EXPECT_EQ(flags(7), 8);
}

TEST_F(UiEdit, LampOverASelectionClearsAFlagThatAnyTileHas) {
  drag(on_sheet(1), on_sheet(3));
  EXPECT_EQ(flag_lamp(level(), session().choices().area, 0), FlagLamp::some);
  click("flags/lamp0");
  EXPECT_EQ(flags(1), 0);
  click("flags/lamp0");
  EXPECT_EQ(flags(1), 1);
  EXPECT_EQ(flags(2), 3);
  EXPECT_EQ(flags(3), 5);
  EXPECT_EQ(flags(4), 0);
}

TEST_F(UiEdit, FlagIsNamedAndGivenARole) {
  click("flags/menu5");
  type("ladder");
  key(KeyChord{'\r'});
  EXPECT_EQ(level().flag_names[5], "ladder");
  click("flags/menu5");
  click("flags/role_solid");
  EXPECT_EQ(level().roles.solid, 5);
  key(KeyChord{27});
  frames(2);
  EXPECT_EQ(find("flags/role_solid"), nullptr) << "Escape closes the menu";
  EXPECT_EQ(session().history().edits().size(), 2u);
  key(ctrl('z'));
  EXPECT_EQ(level().roles.solid, 0);
  EXPECT_EQ(level().flag_names[5], "ladder");
}

TEST_F(UiEdit, ColourIsEditedInOneUndo) {
  click("palette/color12");
  click("tabs/color");
  frames(2);
  const Widget* red = find("palette/red");
  ASSERT_NE(red, nullptr);
  drag(red->centre(), {red->min.x + 1, red->centre().y});
  EXPECT_EQ(level().palette[12].r, 0);
  EXPECT_EQ(level().palette[12].g, default_palette()[12].g);
  EXPECT_EQ(session().history().edits().size(), 1u);
  key(ctrl('z'));
  EXPECT_EQ(level().palette[12], default_palette()[12]);
  key(ctrl('y'));
  EXPECT_EQ(level().palette[12].r, 0);
  click("palette/hex");
  key(ctrl('a'));
  type("102030");
  key(KeyChord{'\r'});
  EXPECT_EQ(level().palette[12], (Rgb{0x10, 0x20, 0x30}));
}

TEST_F(UiEdit, NumberOfAColourIsTypedAfterADoubleClick) {
  click("palette/color12");
  click("tabs/color");
  frames(2);
  click("palette/green_number");
  click("palette/green_number");
  key(ctrl('a'));
  type("77");
  key(KeyChord{'\r'});
  EXPECT_EQ(level().palette[12].g, 77);
}

TEST_F(UiEdit, EscapeCancelsTheDragOfAColour) {
  click("palette/color12");
  click("tabs/color");
  frames(2);
  for (const char* control : {"palette/red", "palette/green_number"}) {
    const ImVec2 at = centre(control);
    move(at);
    press();
    move({at.x - 30, at.y});
    EXPECT_NE(level().palette[12], default_palette()[12]) << control;
    key(KeyChord{27});
    EXPECT_EQ(level().palette[12], default_palette()[12]) << control;
    move({at.x - 50, at.y});
    release();
    EXPECT_EQ(level().palette[12], default_palette()[12]) << control << " is let go";
    EXPECT_TRUE(session().history().edits().empty()) << control;
  }
}

TEST_F(UiEdit, AColourIsTypedAsHexadecimalDigits) {
  click("palette/color12");
  click("tabs/color");
  frames(2);
  const auto type_hex = [&](const std::string& digits, KeyChord end) {
    click("palette/hex");
    key(ctrl('a'));
    type(digits);
    key(end);
    frames(2);
  };
  type_hex("f0f", KeyChord{kKeyTab});
  EXPECT_EQ(level().palette[12], (Rgb{0xff, 0, 0xff}));
  type_hex("102030", KeyChord{27});
  EXPECT_EQ(level().palette[12], (Rgb{0xff, 0, 0xff})) << "Escape takes nothing";
  EXPECT_FALSE(session().message());
  for (const char* wrong : {"ff00", "1", "1122334"}) {
    type_hex(wrong, KeyChord{kKeyEnter});
    EXPECT_EQ(level().palette[12], (Rgb{0xff, 0, 0xff})) << wrong;
    ASSERT_TRUE(session().message()) << wrong;
    EXPECT_NE(session().message()->text.find("is not a colour"), std::string::npos)
        << session().message()->text;
    session().apply(action::DismissMessage{});
  }
  click("palette/hex");
  key(ctrl('a'));
  type("102030");
  click("palette/color3");
  frames(2);
  EXPECT_EQ(level().palette[12], (Rgb{0x10, 0x20, 0x30}));
  EXPECT_EQ(level().palette[3], default_palette()[3]) << "another one was chosen with the click";
  EXPECT_EQ(session().history().edits().size(), 2u);
}

TEST_F(UiEdit, TuningIsDraggedInOneUndoAndReset) {
  click("tabs/tuning");
  frames(2);
  const ImVec2 at = centre("tuning/fall_speed");
  drag(at, {at.x + 40, at.y});
  EXPECT_GT(level().tuning.shared.fall_speed, 5);
  EXPECT_EQ(session().history().edits().size(), 1u);
  frames(2);
  click("tuning/reset_fall_speed");
  EXPECT_EQ(level().tuning.shared.fall_speed, 5);
  key(ctrl('z'));
  EXPECT_GT(level().tuning.shared.fall_speed, 5);
  key(ctrl('z'));
  EXPECT_EQ(level().tuning.shared.fall_speed, 5);
}

TEST_F(UiEdit, TheSolverIsChosen) {
  click("tabs/tuning");
  frames(2);
  click("tuning/solver");
  frames(2);
  click("tuning/solver_bump");
  EXPECT_EQ(level().tuning.solver, SolverKind::bump);
  key(ctrl('z'));
  EXPECT_EQ(level().tuning.solver, SolverKind::article);
}

TEST_F(UiEdit, WhatBodiesAreToOneAnotherIsChosenByWord) {
  click("tabs/tuning");
  frames(2);
  click("tuning/bodies");
  frames(2);
  click("tuning/bodies_meet");
  EXPECT_EQ(level().tuning.shared.pairs(), BodyPairs::meet);
  EXPECT_EQ(level().tuning.solver, SolverKind::exact) << "the only one with which bodies meet";
  key(ctrl('z'));
  EXPECT_EQ(level().tuning.shared.pairs(), BodyPairs::block);
  EXPECT_EQ(level().tuning.solver, SolverKind::article);
}

TEST_F(UiEdit, HistorySaysWhatChangedAndWhere) {
  const auto last = [this] { return describe(session().history().edits().back()); };
  click(on_sheet(1));
  drag(on_map({3, 4}), on_map({11, 4}));
  EXPECT_EQ(last(), "Paint 9 tiles at (3, 4)");
  click(on_map({7, 6}));
  EXPECT_EQ(last(), "Paint 1 tile at (7, 6)");
  key('6');
  drag(on_map({2, 2}), on_map({3, 3}));
  EXPECT_EQ(last(), "Fill rectangle: 4 tiles at (2, 2)");
  click(on_sheet(9));
  click("flags/lamp2");
  EXPECT_EQ(last(), "Set flag 2 of #9");
  click("tabs/tuning");
  frames(2);
  const ImVec2 at = centre("tuning/fall_speed");
  drag(at, {at.x + 40, at.y});
  EXPECT_EQ(last(), "Change fall speed");
}

TEST_F(UiEdit, AClickInTheHistoryGoesBack) {
  click(on_sheet(1));
  for (int x = 1; x <= 3; ++x) click(on_map({x, 2}));
  click("tabs/history");
  frames(2);
  click("history/entry1");
  EXPECT_EQ(tile_at({1, 2}), 1);
  EXPECT_EQ(tile_at({2, 2}), 0);
  click("history/entry3");
  EXPECT_EQ(tile_at({3, 2}), 1);
}

TEST_F(UiEdit, ProblemIsShownOnTheMap) {
  click(on_sheet(1));
  click(on_map({5, 10}));  // paints over the only ball
  ASSERT_FALSE(session().problems().empty());
  click(on_sheet(3));
  click(on_map({20, 4}));  // an up-slope without its other half
  frames(2);
  const auto& problems = session().problems();
  std::size_t row = 0;
  while (row < problems.size() && problems[row].cell != Cell{20, 4}) ++row;
  ASSERT_LT(row, problems.size());
  click("problems/row" + std::to_string(row));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{20, 4}));
}

TEST_F(UiEdit, FlagGetsAShapeWithHeights) {
  click("flags/menu6");
  click("flags/shape");
  click("flags/shape_slope");
  frames(2);  // until the menu shows the additional fields
  TileShape slope{.kind = TileShape::Kind::slope};
  slope.heights = {0, 8};
  EXPECT_EQ(level().flag_shapes[6], slope);
  const ImVec2 right = centre("flags/shape_right");
  drag(right, {right.x - 40, right.y});
  EXPECT_LT(level().flag_shapes[6].heights[1], 8);
  click("flags/shape_one_way");
  EXPECT_TRUE(level().flag_shapes[6].one_way);
  key(ctrl('z'));
  EXPECT_FALSE(level().flag_shapes[6].one_way);
  key(ctrl('z'));
  EXPECT_EQ(level().flag_shapes[6], slope);  // the drag was one edit
  key(ctrl('z'));
  EXPECT_EQ(level().flag_shapes[6], TileShape());
}

// The ends are whole pixels: the corners of cells are beside the middle of the mouse's pixel.
TEST_F(UiEdit, SlopeToolDrawsTilesAlongADraggedLine) {
  click(on_sheet(0));
  key(kKeyF3);
  key('8');
  EXPECT_EQ(session().choices().map_tool, MapTool::slope);
  drag(on_canvas("map", {16, 40}), on_canvas("map", {32, 32}));
  const TileNumber low = tile_at({2, 4}), high = tile_at({3, 4});
  EXPECT_EQ(level().tile_shapes[low], (TileShape{.kind = TileShape::Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(level().tile_shapes[high], (TileShape{.kind = TileShape::Kind::slope, .heights = {4, 8}}));
  EXPECT_EQ(describe(session().history().edits().back()), "Lay a slope: 24 tiles at (2, 4)");
  for (int y = 5; y < 16; ++y) EXPECT_EQ(tile_at({3, y}), 1) << "filled down to the floor";
  EXPECT_EQ(session().history().edits().size(), 1u);
  key(ctrl('z'));
  EXPECT_FALSE(session().modified());
  EXPECT_EQ(tile_at({2, 4}), 0);
  EXPECT_EQ(level().tile_shapes[low], TileShape());
}

TEST_F(UiEdit, SlopeToolUsesTheSelectedSlopes) {
  drag(on_sheet(3), on_sheet(4));
  click("map/slope");
  drag(on_canvas("map", {16, 40}), on_canvas("map", {48, 24}));
  for (Cell cell : {Cell{2, 4}, Cell{4, 3}}) EXPECT_EQ(tile_at(cell), 3);
  for (Cell cell : {Cell{3, 4}, Cell{5, 3}}) EXPECT_EQ(tile_at(cell), 4);
  EXPECT_EQ(level().tile_shapes, test_level().tile_shapes);
}

TEST_F(UiEdit, SlopeThatCannotBeLaidSaysWhy) {
  click("map/slope");
  drag(on_canvas("map", {16, 40}), on_canvas("map", {16, 80}));
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_EQ(session().message()->text, "Slope from 16, 40 to 16, 80: the slope is vertical.");
  EXPECT_FALSE(session().modified());
}

TEST_F(UiEdit, SegmentToolAddsACurveBetweenTwoPoints) {
  click("map/segment");
  drag(on_canvas("map", {16, 40}), on_canvas("map", {51, 27}));
  ASSERT_EQ(level().curves.size(), 1u);
  EXPECT_EQ(level().curves[0].curve, (Curve{Segment{{16, 40}, {51, 27}}, Curve::Faces::up}));
  drag(on_canvas("map", {90, 60}), on_canvas("map", {60, 60}));
  ASSERT_EQ(level().curves.size(), 2u);
  EXPECT_EQ(level().curves[1].curve, (Curve{Segment{{60, 60}, {90, 60}}, Curve::Faces::down}));
  key(ctrl('z'));
  EXPECT_EQ(level().curves.size(), 1u);
  move(on_canvas("map", {34, 35}));
  key(kKeyDelete);
  EXPECT_TRUE(level().curves.empty());
}

}  // namespace talus::edit_ui_test
