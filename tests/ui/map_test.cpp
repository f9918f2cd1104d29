// The map's tools, selection, clipboard and size, and finding tiles, by mouse and keys.
#include <SDL_clipboard.h>

#include "harness.h"
#include "panels/level/edit_text.h"
#include "panels/window/status_panel.h"

namespace talus::map_test {

class UiMap : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start_on_the_map();
  }
  // Rows of the map from a cell on: '.' is tile 0, other tiles are their digit.
  std::vector<std::string> drawn(CellRect cells) {
    std::vector<std::string> rows(static_cast<std::size_t>(cells.h));
    for (int y = 0; y < cells.h; ++y) {
      for (int x = 0; x < cells.w; ++x) {
        const int tile = tile_at({cells.x + x, cells.y + y});
        rows[static_cast<std::size_t>(y)] += tile == 0 ? '.' : static_cast<char>('0' + tile);
      }
    }
    return rows;
  }
  // Paints a row of tiles with the stamp tool, in the order of the sheet.
  void stamp(int first, int last, Cell at) {
    drag(on_sheet(first), on_sheet(last));
    key(kKeyF3);
    key('1');
    click(on_map(at));
  }
  void select(Cell from, Cell to) {
    key(kKeyF3);
    key('3');
    drag(on_map(from), on_map(to));
  }
  std::optional<CellRect> selection() { return session().choices().selection; }
  std::size_t entries() { return session().history().position(); }
  MapTool tool() { return session().choices().map_tool; }
  static std::string clipboard() {
    char* text = SDL_GetClipboardText();
    const std::string copy = text;
    SDL_free(text);
    return copy;
  }
};

using Rows = std::vector<std::string>;

TEST_F(UiMap, KeysChooseTheToolsAsInTic80) {
  const std::pair<int, MapTool> tools[] = {
      {'1', MapTool::stamp},   {'2', MapTool::pan},       {'3', MapTool::select},  {'4', MapTool::fill},
      {'5', MapTool::line},    {'6', MapTool::rectangle}, {'7', MapTool::ellipse}, {'8', MapTool::slope},
      {'9', MapTool::segment}, {'0', MapTool::body},      {'e', MapTool::erase},   {'i', MapTool::pick}};
  for (const auto& [code, expected] : tools) {
    key(code);
    EXPECT_EQ(tool(), expected) << static_cast<char>(code);
  }
}

TEST_F(UiMap, EveryToolHasAButton) {
  for (const auto& [name, expected] : {std::pair("map/select", MapTool::select),
                                       {"map/line", MapTool::line},
                                       {"map/ellipse", MapTool::ellipse},
                                       {"map/rectangle", MapTool::rectangle},
                                       {"map/erase", MapTool::erase},
                                       {"map/stamp", MapTool::stamp}}) {
    click(name);
    EXPECT_EQ(tool(), expected) << name;
  }
}

TEST_F(UiMap, LineIsDrawnAtTheRelease) {
  key('5');
  move(on_map({2, 2}));
  press();
  move(on_map({6, 4}));
  EXPECT_EQ(entries(), 0u) << "only a preview";
  EXPECT_EQ(app().ui().view.canvas.hover.dragged, (Cell{5, 3}));
  release();
  EXPECT_EQ(drawn({2, 2, 5, 3}), (Rows{"1....", ".11..", "...11"}));
  EXPECT_EQ(entries(), 1u);
  key(ctrl('z'));
  EXPECT_FALSE(session().modified());
}

TEST_F(UiMap, RectangleIsFilledAndWithShiftAnOutline) {
  key('6');
  drag(on_map({2, 2}), on_map({4, 4}));
  EXPECT_EQ(drawn({2, 2, 3, 3}), (Rows{"111", "111", "111"}));
  move(on_map({8, 2}));
  press();
  hold_modifiers(shift(0));
  move(on_map({10, 4}));
  release();
  hold_modifiers();
  EXPECT_EQ(drawn({8, 2, 3, 3}), (Rows{"111", "1.1", "111"}));
  EXPECT_EQ(describe(session().history().edits().back()), "Outline rectangle: 8 tiles at (8, 2)");
}

TEST_F(UiMap, EllipseFitsTheDraggedRectangle) {
  key('7');
  drag(on_map({7, 5}), on_map({4, 2}));
  EXPECT_EQ(drawn({4, 2, 4, 4}), (Rows{".11.", "1111", "1111", ".11."}));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(UiMap, ShapesAndFillStayInsideTheSelection) {
  select({2, 2}, {4, 3});
  key('6');
  drag(on_map({0, 0}), on_map({3, 9}));
  EXPECT_EQ(drawn({1, 1, 5, 4}), (Rows{".....", ".11..", ".11..", "....."}));
  click(on_sheet(5));
  key(kKeyF3);
  key('4');
  click(on_map({4, 2}));
  EXPECT_EQ(drawn({1, 1, 5, 4}), (Rows{".....", ".115.", ".115.", "....."}));
  click(on_map({10, 8}));
  EXPECT_EQ(tile_at({10, 8}), 0);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "The tools stay inside the selection: draw there, or select nothing first.");
}

TEST_F(UiMap, StrokesStayInsideTheSelection) {
  const std::string hint = "The tools stay inside the selection: draw there, or select nothing first.";
  select({2, 2}, {4, 3});
  key('1');
  drag(on_map({3, 2}), on_map({9, 2}));
  EXPECT_EQ(drawn({1, 1, 9, 4}), (Rows{".........", "..11.....", ".........", "........."}));
  EXPECT_FALSE(session().message());
  click(on_map({7, 7}));
  EXPECT_EQ(tile_at({7, 7}), 0);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, hint);
  key('d');
  drag(on_map({1, 3}), on_map({6, 3}));
  EXPECT_EQ(drawn({1, 1, 9, 4}), (Rows{".........", "..11.....", ".111.....", "........."}));
  EXPECT_EQ(entries(), 2u);
  key(27);
  EXPECT_FALSE(selection());
  key('1');
  drag(on_map({1, 4}), on_map({6, 4}));
  select({2, 2}, {4, 4});
  key('e');
  drag(on_map({3, 4}), on_map({9, 4}));
  EXPECT_EQ(drawn({1, 1, 9, 4}), (Rows{".........", "..11.....", ".111.....", "11..11..."}));
  session().apply(action::DismissMessage{});
  click(on_map({6, 4}));
  EXPECT_EQ(tile_at({6, 4}), 1);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, hint);
}

TEST_F(UiMap, GroundAndSlopesStayInsideTheSelection) {
  key(shift('g'));
  key(kKeyF3);
  select({2, 2}, {4, 3});
  key('g');
  drag(on_map({3, 2}), on_map({9, 2}));
  EXPECT_EQ(drawn({1, 1, 9, 4}), (Rows{".........", "..11.....", ".........", "........."}));
  hold_modifiers(shift(0));
  drag(on_map({0, 3}), on_map({9, 9}));
  hold_modifiers();
  EXPECT_EQ(drawn({1, 1, 9, 4}), (Rows{".........", "..34.....", ".111.....", "........."}))
      << "two halves of a slope";
  click(on_map({9, 9}));
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "The tools stay inside the selection: draw there, or select nothing first.");
  key(27);
  select({12, 2}, {13, 9});
  key('8');
  drag(on_canvas("map", {80, 40}), on_canvas("map", {136, 40}));
  EXPECT_EQ(tile_at({11, 5}), 0);
  EXPECT_NE(tile_at({12, 5}), 0);
  EXPECT_NE(tile_at({13, 5}), 0);
  EXPECT_EQ(tile_at({14, 5}), 0);
}

TEST_F(UiMap, FillWithCtrlReplacesTheTileEverywhere) {
  stamp(3, 3, {2, 2});
  click(on_map({9, 8}));
  click(on_sheet(6));
  key(kKeyF3);
  key('4');
  hold_modifiers(ctrl(0));
  click(on_map({2, 2}));
  hold_modifiers();
  EXPECT_EQ(tile_at({2, 2}), 6);
  EXPECT_EQ(tile_at({9, 8}), 6);
  EXPECT_EQ(tile_at({3, 2}), 0);
}

TEST_F(UiMap, MiddleButtonPicksWithAnyTool) {
  stamp(3, 6, {10, 8});
  key('7');
  click(on_map({11, 8}), kMiddle);
  frames(2);
  EXPECT_EQ(session().choices().stamp, (Stamp{1, 1, {4}}));
  drag(on_map({11, 8}), on_map({12, 8}), kMiddle);
  EXPECT_EQ(session().choices().stamp, (Stamp{1, 1, {4}})) << "a drag moves the view";
  key(ctrl(','));
  frames(3);
  click("settings/middle_picks");
  key(kKeyEscape);
  frames(3);
  drag(on_map({11, 8}), on_map({12, 8}), kMiddle);
  EXPECT_EQ(session().choices().stamp, (Stamp{2, 1, {4, 5}}));
  EXPECT_EQ(tool(), MapTool::stamp);
  EXPECT_EQ(entries(), 1u) << "nothing is painted";
}

TEST_F(UiMap, ClicksAndEscapeChangeTheSelection) {
  key('3');
  click(on_map({5, 5}));
  EXPECT_EQ(selection(), (CellRect{5, 5, 1, 1}));
  click(on_map({8, 5}));
  EXPECT_EQ(selection(), std::nullopt) << "a click elsewhere";
  drag(on_map({9, 6}), on_map({7, 3}));
  EXPECT_EQ(selection(), (CellRect{7, 3, 3, 4}));
  key(kKeyEscape);
  EXPECT_EQ(selection(), std::nullopt);
  key(ctrl('a'));
  EXPECT_EQ(selection(), (CellRect{0, 0, 30, 17}));
  EXPECT_EQ(entries(), 0u);
}

TEST_F(UiMap, EscapeCancelsADrag) {
  const auto cancel_drag = [&](Cell from, Cell to) {
    move(on_map(from));
    press();
    move(on_map(to));
    key(kKeyEscape);
    move(on_map({to.x + 1, to.y}));
    release();
  };
  stamp(3, 4, {3, 3});
  for (const char* tool :
       {"map/stamp", "map/erase", "map/rectangle", "map/ellipse", "map/line", "map/fill"}) {
    click(tool);
    cancel_drag({3, 3}, {9, 5});
    EXPECT_EQ(drawn({3, 3, 7, 3}), (Rows{"34.....", ".......", "......."})) << tool;
  }
  click("map/select");
  cancel_drag({3, 3}, {6, 5});
  EXPECT_EQ(selection(), std::nullopt);
  select({3, 3}, {4, 3});
  cancel_drag({10, 8}, {12, 9});
  EXPECT_EQ(selection(), (CellRect{3, 3, 2, 1})) << "the previous selection comes back";
  drag(on_map({3, 3}), on_map({3, 4}));
  cancel_drag({4, 4}, {8, 5});
  EXPECT_EQ(selection(), (CellRect{3, 4, 2, 1}));
  EXPECT_EQ(drawn({3, 3, 7, 3}), (Rows{".......", "34.....", "......."})) << "the previous move stays";
  EXPECT_EQ(session().history().position(), 2u);
}

TEST_F(UiMap, SelectionIsMovedByTheMouseInOneEntry) {
  stamp(3, 4, {3, 3});
  stamp(1, 1, {6, 3});
  select({3, 3}, {4, 3});
  const std::size_t before = entries();
  drag(on_map({4, 3}), on_map({8, 5}));
  EXPECT_EQ(drawn({3, 3, 7, 3}), (Rows{"...1...", ".......", "....34."}));
  EXPECT_EQ(selection(), (CellRect{7, 5, 2, 1}));
  EXPECT_EQ(entries(), before + 1);
  key(ctrl('z'));
  EXPECT_EQ(drawn({3, 3, 4, 1}), Rows{"34.1"});
  EXPECT_EQ(selection(), (CellRect{3, 3, 2, 1}));
}

TEST_F(UiMap, SelectionIsMovedByTheArrowsOverOtherTiles) {
  stamp(3, 4, {3, 3});
  stamp(1, 1, {5, 3});
  select({3, 3}, {4, 3});
  const std::size_t before = entries();
  for (int i = 0; i < 3; ++i) key(kKeyRight);
  EXPECT_EQ(drawn({3, 3, 5, 1}), Rows{"..134"}) << "the tiles that it crossed are there again";
  key(kKeyDown);
  EXPECT_EQ(drawn({3, 3, 5, 2}), (Rows{"..1..", "...34"}));
  EXPECT_EQ(entries(), before + 1);
}

TEST_F(UiMap, DragWithCtrlLeavesACopy) {
  stamp(3, 4, {3, 3});
  select({3, 3}, {4, 3});
  hold_modifiers(ctrl(0));
  drag(on_map({3, 3}), on_map({6, 4}));
  hold_modifiers();
  EXPECT_EQ(drawn({3, 3, 5, 2}), (Rows{"34...", "...34"}));
}

TEST_F(UiMap, CutCopyAndPasteUseTheTextOfTic80) {
  stamp(3, 6, {3, 3});
  select({3, 3}, {6, 3});
  key(ctrl('c'));
  EXPECT_EQ(clipboard(), "401030405060");
  key(ctrl('x'));
  EXPECT_EQ(drawn({3, 3, 4, 1}), Rows{"...."});
  EXPECT_EQ(describe(session().history().edits().back()), "Cut 4 tiles at (3, 3)");
  key(ctrl('v'));
  EXPECT_TRUE(session().choices().pasted);
  move(on_map({10, 8}));
  EXPECT_EQ(tile_at({10, 8}), 0) << "it hangs at the mouse";
  click(on_map({10, 8}));
  EXPECT_EQ(drawn({9, 8, 4, 1}), Rows{"3456"}) << "its middle is at the mouse";
  EXPECT_FALSE(session().choices().pasted);
  EXPECT_EQ(selection(), (CellRect{9, 8, 4, 1}));
  key(kKeyUp);
  EXPECT_EQ(drawn({9, 7, 4, 2}), (Rows{"3456", "...."}));
  key(ctrl('z'));
  EXPECT_EQ(drawn({9, 7, 4, 2}), (Rows{"....", "...."})) << "pasting and moving are one";
}

TEST_F(UiMap, PasteAcceptsTextOfTic80AndReportsOtherText) {
  ASSERT_EQ(SDL_SetClipboardText("20103040"), 0);
  key(ctrl('v'));
  click(on_map({12, 4}));
  EXPECT_EQ(drawn({12, 4, 2, 1}), Rows{"34"});
  key(ctrl('v'));
  key(kKeyEscape);
  EXPECT_FALSE(session().choices().pasted) << "the first Escape removes the pasted tiles";
  EXPECT_TRUE(selection()) << "the selection stays until the next Escape";
  ASSERT_EQ(SDL_SetClipboardText("hello"), 0);
  key(ctrl('v'));
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Nothing to paste: the clipboard holds no tiles of a map.");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(UiMap, SelectionIsFilledAndDeleted) {
  drag(on_sheet(3), on_sheet(4));
  select({3, 3}, {5, 4});
  key(shift('f'));
  EXPECT_EQ(drawn({3, 3, 3, 2}), (Rows{"343", "343"}));
  key(kKeyDelete);
  EXPECT_EQ(drawn({3, 3, 3, 2}), (Rows{"...", "..."}));
  EXPECT_EQ(entries(), 2u);
}

TEST_F(UiMap, MirroringReplacesSlopesByTheirPartners) {
  stamp(3, 4, {3, 3});
  stamp(1, 1, {5, 3});
  select({3, 3}, {5, 3});
  key('h');
  EXPECT_EQ(tile_at({3, 3}), 1);
  EXPECT_EQ(tile_at({4, 3}), 5) << "the down-slope's half with the flag";
  EXPECT_FALSE(session().message());
  key('v');
  EXPECT_FALSE(session().message());
  EXPECT_EQ(level().map.at({4, 3}), MapCell(5, TileTurn::up_down)) << "a tile without a mirror image turns";
}

TEST_F(UiMap, StatusBarShowsTileFlagsAndPlace) {
  stamp(1, 1, {4, 5});
  move(on_map({4, 5}));
  EXPECT_EQ(app().ui().view.canvas.hover.cell, (Cell{4, 5}));
  EXPECT_NE(find("status/mouse"), nullptr);
  const auto told = [&] { return hover_text(session(), app().ui().view.canvas.hover); };
  EXPECT_EQ(told().substr(0, told().find("px")), "(4, 5)  tile 1 (solid)   ");
  move(on_canvas("map", {36, 44}));
  EXPECT_EQ(told(), "(4, 5)  tile 1 (solid)   px 36, 44");
  move(on_sheet(3));
  EXPECT_EQ(told(), "tile 3");
}

TEST_F(UiMap, ShiftShowsTheSheetOverTheMap) {
  key('3');
  move(on_map({4, 5}));
  EXPECT_EQ(find("map/sheet"), nullptr);
  hold_modifiers(shift(0));
  frames(2);
  const Widget* sheet = find("map/sheet");
  ASSERT_NE(sheet, nullptr);
  const ImVec2 min = sheet->min;
  const float cell = (sheet->max.x - sheet->min.x) / 16;
  drag({min.x + 2.5f * cell, min.y + 1.5f * cell}, {min.x + 3.5f * cell, min.y + 1.5f * cell});
  hold_modifiers();
  frames(2);
  EXPECT_EQ(find("map/sheet"), nullptr);
  EXPECT_EQ(session().choices().stamp, (Stamp{2, 1, {18, 19}}));
  EXPECT_EQ(tool(), MapTool::stamp);
  EXPECT_EQ(entries(), 0u) << "nothing was painted through it";
}

TEST_F(UiMap, MapIsResizedAfterAQuestionAboutLosses) {
  key(ctrl('e'));
  frames(3);
  click("resize/width");
  key(ctrl('a'));
  type("20");
  key(kKeyTab);
  frames(2);
  const ImVec2 resize = centre("resize/apply");
  click(resize);
  frames(2);
  EXPECT_EQ(level().map.width(), 30) << "10 tiles of the floor would be lost: it asks first";
  click(resize);
  frames(2);
  EXPECT_EQ(level().map.width(), 30) << "where the button was, the same click again loses nothing";
  EXPECT_TRUE(app().ui().view.level.resize_open);
  click(resize);
  frames(2);
  click("resize/apply");
  frames(3);
  EXPECT_EQ(level().map.width(), 20);
  EXPECT_EQ(level().map.height(), 17);
  EXPECT_FALSE(app().ui().view.level.resize_open);
  key(ctrl('z'));
  EXPECT_EQ(level().map, test_level().map);
}

TEST_F(UiMap, MapKeepsItsSizeIfTheTypedOneIsInvalid) {
  key(ctrl('e'));
  frames(3);
  const auto set = [&](const char* field, const char* text) {
    click(field);
    key(ctrl('a'));
    type(text);
    key(kKeyTab);
    frames(2);
  };
  for (const char* wrong : {"-5", "0", "2097153", "200000"}) {  // 200000x136 cells are too many
    set("resize/height", "136");
    set("resize/width", wrong);
    EXPECT_FALSE(find("resize/apply")->enabled) << wrong;
    EXPECT_TRUE(app().ui().view.level.resize_open) << wrong;
  }
  set("resize/width", "40");
  set("resize/right", "99999999");
  EXPECT_FALSE(find("resize/apply")->enabled);
  set("resize/right", "0");
  EXPECT_TRUE(find("resize/apply")->enabled);
  click("resize/apply");
  frames(3);
  EXPECT_EQ(level().map.width(), 40);
  EXPECT_EQ(level().map.height(), 136);
}

TEST_F(UiMap, MapGrowsAtTheChosenSide) {
  key(ctrl('e'));
  frames(3);
  click("resize/anchor8");
  click("resize/height");
  key(ctrl('a'));
  type("20");
  key(kKeyTab);
  frames(2);
  click("resize/apply");
  frames(3);
  ASSERT_EQ(level().map.height(), 20);
  EXPECT_EQ(tile_at({0, 19}), 1) << "the floor stays at the bottom";
  EXPECT_EQ(tile_at({5, 13}), 2);
}

TEST_F(UiMap, EscapeLeavesTheMapsSizeAlone) {
  key(ctrl('e'));
  frames(3);
  click("resize/width");
  key(ctrl('a'));
  type("20");
  click("resize/cancel");
  frames(3);
  EXPECT_FALSE(app().ui().view.level.resize_open);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiMap, TilesAreFoundAndReplaced) {
  stamp(3, 3, {2, 2});
  click(on_map({20, 12}));
  key(ctrl('h'));
  frames(3);
  EXPECT_EQ(app().ui().view.level.find_tile, 3) << "the chosen tile";
  click("find_tiles/next");
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{2, 2}));
  click("find_tiles/next");
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{20, 12}));
  click("find_tiles/previous");
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{2, 2}));
  click("find_tiles/replace");
  key(ctrl('a'));
  type("6");
  key(KeyChord{'\r'});
  frames(2);
  click("find_tiles/replace_all");
  EXPECT_EQ(tile_at({2, 2}), 6);
  EXPECT_EQ(tile_at({20, 12}), 6);
  EXPECT_EQ(describe(session().history().edits().back()), "Replace 2 tiles at (2, 2)");
}

TEST_F(UiMap, FindTakesTheDigits) {
  stamp(3, 3, {2, 2});
  move(on_map({20, 12}));
  const MapTool before = tool();
  for (const char* number : {"6", "12"}) {  // the second time the window is open already
    key(ctrl('h'));
    frames(3);
    type(number);
    key(KeyChord{'\r'});
    frames(2);
    EXPECT_EQ(app().ui().view.level.find_tile, std::stoi(number)) << "the typed number replaces the old one";
    EXPECT_EQ(tool(), before) << "no digit chooses a tool";
    move(on_map({21, 12}));
  }
  key(ctrl('h'));
  frames(3);
  type("999");
  frames(2);
  EXPECT_NE(find("find_tiles/problem"), nullptr) << "no tile has this number";
  EXPECT_FALSE(find("find_tiles/next")->enabled);
  click("find_tiles/find_take");
  frames(2);
  EXPECT_EQ(app().ui().view.level.find_tile, 3);
  EXPECT_EQ(find("find_tiles/problem"), nullptr);
  EXPECT_TRUE(find("find_tiles/next")->enabled);
}

TEST_F(UiMap, EscapeOrAClickRemovesTheMarkOfAFoundTile) {
  const auto& marked = app().ui().view.canvas.marked_cell;
  stamp(3, 3, {2, 2});
  click(on_map({20, 12}));
  key(ctrl('a'));
  key('n');
  ASSERT_EQ(marked, (Cell{2, 2}));
  key(KeyChord{kKeyEscape});
  EXPECT_FALSE(marked);
  EXPECT_TRUE(session().choices().selection) << "the next Escape removes the selection";
  key(KeyChord{kKeyEscape});
  EXPECT_FALSE(session().choices().selection);
  move(on_map({10, 5}));
  key('n');
  ASSERT_EQ(marked, (Cell{20, 12}));
  key('1');
  click(on_map({19, 12}));
  EXPECT_FALSE(marked);
  key('n');
  EXPECT_EQ(marked, (Cell{20, 12})) << "the search goes on from the mouse";
}

TEST_F(UiMap, TheKeyFindsTheNextCellOfTheChosenTile) {
  stamp(3, 3, {2, 2});
  click(on_map({20, 12}));
  key('n');
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{2, 2}));
  key(shift('n'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{20, 12}));
  click(on_sheet(7));
  key(kKeyF3);
  key('n');
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "The map has no tile 7.");
}

}  // namespace talus::map_test
