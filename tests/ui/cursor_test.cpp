// Drawing by the keyboard alone: no test here moves or presses the mouse.
#include "edit/map_rectangle.h"
#include "edit/map_resize.h"
#include "edit/map_selection.h"
#include "harness.h"

namespace talus::cursor_test {

class UiCursor : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  KeyCursor& cursor() { return app().ui().view.canvas.cursor; }
  void press_key(KeyChord chord) {
    key(chord);
    frames(2);
  }
  void press_key(int key_code) { press_key(KeyChord{key_code}); }
  void go(KeyChord chord, int times) {
    for (int i = 0; i < times; ++i) key(chord);
    frames(2);
  }
  // Moves the cursor there by arrows alone.
  void go_to(Cell to) {
    ASSERT_TRUE(hovered()) << "the cursor is on no cell";
    const Cell from = *hovered();
    go(KeyChord{to.x < from.x ? kKeyLeft : kKeyRight}, std::abs(to.x - from.x));
    go(KeyChord{to.y < from.y ? kKeyUp : kKeyDown}, std::abs(to.y - from.y));
    ASSERT_EQ(hovered(), to);
  }
  std::optional<Cell> hovered() {
    const Hover& hover = app().ui().view.canvas.hover;
    return hover.sprite ? hover.sprite : hover.cell;
  }
  void choose_tile(int tile) {
    session().apply(action::SelectTiles{{SheetId::tiles, {tile % 16, tile / 16, 1, 1}}});
  }
  std::uint8_t pixel(int tile, int x, int y) {
    return level()
        .sheet(SheetId::tiles)
        .images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(y * 8 + x)];
  }
};

TEST_F(UiCursor, EnterWithAltIsAnotherKey) {
  press_key(alt(kKeyEnter));
  EXPECT_TRUE(app().ui().view.window.full_screen);
  EXPECT_FALSE(app().ui().view.canvas.cursor.on());
  press_key(alt(kKeyEnter));
  EXPECT_FALSE(app().ui().view.window.full_screen);
}

TEST_F(UiCursor, EnterShowsItAndEscapeEndsIt) {
  key(kKeyF3);
  EXPECT_FALSE(hovered());
  press_key(kKeyEnter);
  EXPECT_TRUE(cursor().is_on("map"));
  ASSERT_TRUE(hovered());
  const Cell at = *hovered();
  press_key(kKeyRight);
  EXPECT_EQ(hovered(), (Cell{at.x + 1, at.y}));
  press_key(shift(kKeyLeft));
  EXPECT_EQ(hovered(), (Cell{at.x - 7, at.y}));
  press_key(ctrl_shift(kKeyDown));
  EXPECT_EQ(app().ui().view.canvas.hover.pixel->y, at.y * 8 + 5);
  press_key(kKeyEscape);
  EXPECT_FALSE(cursor().on());
  EXPECT_FALSE(hovered());
  EXPECT_TRUE(session().history().edits().empty());
}

TEST_F(UiCursor, ARowIsPaintedByHoldingSpaceInOneUndo) {
  // The arrows choose a tile of the sheet from the program's first frame on.
  key(kKeyF2);
  go(KeyChord{kKeyRight}, 2);  // from the first that is drawn
  EXPECT_EQ(session().choices().stamp.tiles, std::vector<MapCell>{3});
  key(kKeyF3);
  press_key(kKeyEnter);
  go_to({4, 5});
  hold(' ');
  go(KeyChord{kKeyRight}, 5);
  let_go(' ');
  frames(2);
  for (int x = 4; x <= 9; ++x) EXPECT_EQ(tile_at({x, 5}), 3) << x;
  EXPECT_EQ(tile_at({10, 5}), 0);
  press_key(kKeyRight);
  EXPECT_EQ(tile_at({10, 5}), 0) << "nothing is held any more";
  EXPECT_EQ(session().history().edits().size(), 1u);
  key(ctrl('z'));
  for (int x = 4; x <= 9; ++x) EXPECT_EQ(tile_at({x, 5}), 0) << x;
  EXPECT_FALSE(session().modified());
}

TEST_F(UiCursor, ATapClicksAtTheCursor) {
  key(kKeyF3);
  choose_tile(1);
  press_key(kKeyEnter);
  go_to({7, 3});
  // All events come in one frame, as in a slow program.
  push_stroke({kKeyRight});
  push_stroke({' '});
  push_stroke({kKeyRight});
  frames(6);
  EXPECT_EQ(tile_at({7, 3}), 0);
  EXPECT_EQ(tile_at({8, 3}), 1);
  EXPECT_EQ(tile_at({9, 3}), 0);
  EXPECT_EQ(hovered(), (Cell{9, 3}));
}

TEST_F(UiCursor, ARectangleIsDrawnFromCornerToCorner) {
  key(kKeyF3);
  choose_tile(1);
  press_key('6');
  press_key(kKeyEnter);
  go_to({3, 2});
  press_key(kKeyEnter);
  EXPECT_TRUE(cursor().pen_down());
  go_to({6, 4});
  EXPECT_EQ(app().ui().view.canvas.hover.dragged, (Cell{4, 3})) << "for the status bar";
  EXPECT_EQ(tile_at({3, 2}), 0);
  press_key(kKeyEnter);
  for (int y = 2; y <= 4; ++y)
    for (int x = 3; x <= 6; ++x) EXPECT_EQ(tile_at({x, y}), 1) << x << "," << y;
  EXPECT_EQ(tile_at({7, 4}), 0);
  // Shift draws the outline alone.
  press_key(ctrl('z'));
  go_to({3, 2});
  press_key(kKeyEnter);
  go_to({6, 4});
  press_key(shift(kKeyEnter));
  EXPECT_FALSE(cursor().pen_down());
  EXPECT_EQ(tile_at({3, 2}), 1);
  EXPECT_EQ(tile_at({4, 3}), 0);
  // Escape lifts the pen without drawing.
  press_key(ctrl('z'));
  go_to({3, 2});
  press_key(kKeyEnter);
  go_to({6, 4});
  press_key(kKeyEscape);
  EXPECT_FALSE(cursor().pen_down());
  EXPECT_TRUE(cursor().on());
  frames(2);
  EXPECT_EQ(tile_at({3, 2}), 0);
}

TEST_F(UiCursor, LineEllipseFillAndBrushWorkAtTheCursor) {
  key(kKeyF3);
  choose_tile(1);
  press_key(kKeyEnter);
  go_to({10, 4});
  press_key('5');
  press_key(kKeyEnter);
  go_to({14, 8});
  press_key(kKeyEnter);
  for (int i = 0; i <= 4; ++i) EXPECT_EQ(tile_at({10 + i, 4 + i}), 1) << i;
  press_key('7');
  go_to({16, 2});
  press_key(kKeyEnter);
  go_to({20, 6});
  press_key(kKeyEnter);
  EXPECT_EQ(tile_at({18, 2}), 1);
  EXPECT_EQ(tile_at({16, 2}), 0);
  choose_tile(3);
  press_key('4');
  go_to({18, 4});
  press_key(' ');
  EXPECT_EQ(tile_at({18, 2}), 3) << "the ellipse is of one tile";
  press_key('e');
  press_key(' ');
  EXPECT_EQ(tile_at({18, 4}), 0);
  EXPECT_EQ(tile_at({18, 3}), 3);
}

TEST_F(UiCursor, ASelectionIsMadeMovedAndCleared) {
  session().apply(action::EditLevel{fill_rect(level(), {3, 3, 2, 2}, Stamp{1, 1, {1}})});
  key(kKeyF3);
  press_key('3');
  press_key(kKeyEnter);
  go_to({3, 3});
  press_key(kKeyEnter);
  go_to({4, 4});
  press_key(kKeyEnter);
  EXPECT_EQ(session().choices().selection, (CellRect{3, 3, 2, 2}));
  hold(' ');
  go(KeyChord{kKeyRight}, 6);
  let_go(' ');
  frames(2);
  EXPECT_EQ(tile_at({3, 3}), 0);
  EXPECT_EQ(tile_at({9, 3}), 1);
  EXPECT_EQ(tile_at({10, 4}), 1);
  press_key(ctrl('z'));
  EXPECT_EQ(tile_at({3, 3}), 1);
  EXPECT_EQ(tile_at({9, 3}), 0);
  // Without the cursor the arrows move the selection, as before.
  press_key(kKeyEscape);
  press_key(kKeyDown);
  EXPECT_EQ(tile_at({3, 3}), 0);
  EXPECT_EQ(tile_at({3, 5}), 1);
}

TEST_F(UiCursor, PixelsAreDrawnInBothColours) {
  key(kKeyF2);
  session().apply(action::SetColor{9, false});
  session().apply(action::SetColor{4, true});
  choose_tile(20);
  press_key(kKeyEnter);
  EXPECT_TRUE(cursor().is_on("pixels"));
  go_to({1, 2});
  hold(' ');
  go(KeyChord{kKeyRight}, 3);
  let_go(' ');
  frames(2);
  press_key(kKeyDown);
  press_key(kKeyBackspace);
  for (int x = 1; x <= 4; ++x) EXPECT_EQ(pixel(20, x, 2), 9) << x;
  EXPECT_EQ(pixel(20, 5, 2), 0);
  EXPECT_EQ(pixel(20, 4, 3), 4);
  press_key('r');  // a rectangle
  go_to({2, 4});
  press_key(kKeyEnter);
  go_to({5, 7});
  press_key(kKeyEnter);
  EXPECT_EQ(pixel(20, 2, 4), 9);
  EXPECT_EQ(pixel(20, 5, 6), 9);
  EXPECT_EQ(pixel(20, 3, 5), 0);
  go(shift(kKeyRight), 1);
  EXPECT_EQ(hovered(), (Cell{7, 7})) << "it stays on the canvas";
  for (int i = 0; i < 3; ++i) key(ctrl('z'));
  EXPECT_EQ(pixel(20, 1, 2), 0);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiCursor, FlagsArePaintedOnTheTileUnderTheCursor) {
  key(kKeyF3);
  session().apply(action::SetFlagOverlay{pattern_of_flag(5)});
  press_key(ctrl_shift('f'));
  ASSERT_EQ(session().choices().map_tool, MapTool::flag);
  press_key(kKeyEnter);
  go_to({8, 16});
  press_key(' ');
  EXPECT_EQ(level().tile_flags(1), 1 | 1 << 5);
  press_key(ctrl('z'));
  EXPECT_EQ(level().tile_flags(1), 1);
}

TEST_F(UiCursor, ASegmentAndItsHandles) {
  key(kKeyF3);
  press_key('9');
  press_key(kKeyEnter);
  go(shift(kKeyLeft), 4);
  go(shift(kKeyUp), 4);
  go(KeyChord{kKeyRight}, 3);
  go(KeyChord{kKeyDown}, 2);
  hold(' ');
  go(KeyChord{kKeyRight}, 4);
  let_go(' ');
  frames(2);
  ASSERT_EQ(level().curves.size(), 1u);
  const auto& line = std::get<Segment>(level().curves[0].curve.form);
  EXPECT_EQ(line.from, (Vec2{24, 16}));
  EXPECT_EQ(line.to, (Vec2{56, 16}));
  hold(' ');  // the segment's end, which is a handle now
  go(KeyChord{kKeyDown}, 1);
  let_go(' ');
  frames(2);
  ASSERT_EQ(level().curves.size(), 1u);
  EXPECT_EQ(std::get<Segment>(level().curves[0].curve.form).to, (Vec2{56, 24}));
}

TEST_F(UiCursor, TheViewScrollsWithTheCursor) {
  session().apply(action::EditLevel{resize_map(level(), {.width = 240, .height = 136}, std::nullopt)});
  frames(2);
  key(kKeyF3);
  choose_tile(1);
  press_key(kKeyEnter);
  go(shift(kKeyRight), 20);
  go(shift(kKeyDown), 10);
  ASSERT_TRUE(hovered());
  EXPECT_GT(hovered()->x, 100);
  EXPECT_GT(hovered()->y, 60);
  const Cell at = *hovered();
  press_key(' ');
  EXPECT_EQ(tile_at(at), 1);
}

TEST_F(UiCursor, FollowsTheKeysFromCanvasToCanvas) {
  key(kKeyF3);
  choose_tile(1);
  press_key(kKeyEnter);
  press_key(kKeyEnter);
  EXPECT_TRUE(cursor().pen_down());
  press_key(kKeyF2);
  EXPECT_TRUE(cursor().is_on("pixels"));
  EXPECT_FALSE(cursor().pen_down());
  EXPECT_EQ(session().history().edits().size(), 1u) << "the pen was taken up where it was";
  std::vector<std::string> seen;
  for (const char* canvas : {"map", "play", "pixels", "sheet"}) {
    for (int i = 0; i < 6 && !cursor().is_on(canvas); ++i) press_key(ctrl(kKeyTab));
    EXPECT_TRUE(cursor().is_on(canvas)) << canvas;
  }
  EXPECT_TRUE(app().ui().view.canvas.hover.tile) << "on the sheet";
  EXPECT_EQ(session().history().edits().size(), 1u);
}

TEST_F(UiCursor, KeepsTheKeysFromPlayersUntilItEnds) {
  Level with_player = test_level();
  with_player.tuning.solver = SolverKind::exact;
  with_player.spawns.push_back({"", {40, 40}, {}, "", BodyKind::player, {8, 8}});
  session().apply(
      action::EditLevel{replace_by(level(), std::make_shared<const Level>(with_player), "a player")});
  key(kKeyF3);
  press_key(kKeyEnter);
  const Cell at = *hovered();
  session().apply(action::Play{});
  hold(kKeyRight);
  EXPECT_FALSE(session().playback().input.right);
  let_go(kKeyRight);
  frames(2);
  EXPECT_EQ(hovered(), (Cell{at.x + 1, at.y}));
  press_key(kKeyEscape);
  hold(kKeyRight);
  EXPECT_TRUE(session().playback().input.right);
  let_go(kKeyRight);
}

TEST_F(UiCursor, OtherKeysCanBeBound) {
  KeyBindings& bindings = app().ui().view.preferences.keys;
  bindings.changed["cursor/right"] = {KeyChord{'x'}, KeyChord{}};
  key(kKeyF3);
  press_key(kKeyEnter);
  const Cell at = *hovered();
  press_key('x');
  EXPECT_EQ(hovered(), (Cell{at.x + 1, at.y}));
}

}  // namespace talus::cursor_test
