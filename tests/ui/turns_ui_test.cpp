// The keys that flip and turn the stamp and the selected tiles.
#include "harness.h"
#include "panels/window/status_panel.h"

namespace talus::turns_ui_test {

class UiTurns : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start_on_the_map();
  }
  MapCell cell_at(Cell cell) { return level().map.at(cell); }
  const Stamp& stamp() { return session().choices().stamp; }
};

TEST_F(UiTurns, KeysTurnTheStamp) {
  drag(on_sheet(3), on_sheet(4));
  key(kKeyF3);
  key('x');
  EXPECT_EQ(stamp().tiles, (std::vector<MapCell>{{4, TileTurn::left_right}, {3, TileTurn::left_right}}));
  key('x');
  key('y');
  EXPECT_EQ(stamp().tiles, (std::vector<MapCell>{{3, TileTurn::up_down}, {4, TileTurn::up_down}}));
  key('y');
  key('z');
  EXPECT_EQ(stamp().h, 2);
  EXPECT_EQ(stamp().tiles, (std::vector<MapCell>{{3, kTurnRight}, {4, kTurnRight}}));
  click(on_map({10, 8}));
  EXPECT_EQ(cell_at({10, 8}), MapCell(3, kTurnRight));
  EXPECT_EQ(cell_at({10, 9}), MapCell(4, kTurnRight));
  EXPECT_NE(hover_text(session(), app().ui().view.canvas.hover).find("tile 3, turned right"),
            std::string::npos);
  key(shift('z'));
  EXPECT_EQ(stamp().tiles, (std::vector<MapCell>{3, 4}));
  key(ctrl('z'));
  EXPECT_EQ(cell_at({10, 8}), MapCell());
}

TEST_F(UiTurns, KeysTurnTheSelectedTiles) {
  drag(on_sheet(3), on_sheet(4));
  key(kKeyF3);
  click(on_map({10, 8}));
  key('3');
  drag(on_map({10, 8}), on_map({11, 8}));
  key('x');
  EXPECT_EQ(cell_at({10, 8}), MapCell(4, TileTurn::left_right));
  EXPECT_EQ(cell_at({11, 8}), MapCell(3, TileTurn::left_right));
  EXPECT_EQ(stamp().tiles, (std::vector<MapCell>{3, 4})) << "the stamp stays";
  key('x');
  key('z');
  EXPECT_EQ(session().choices().selection, (CellRect{10, 8, 1, 2}));
  EXPECT_EQ(cell_at({10, 9}), MapCell(4, kTurnRight));
  EXPECT_EQ(cell_at({11, 8}), MapCell());
  key(ctrl('z'));
  EXPECT_EQ(session().choices().selection, (CellRect{10, 8, 2, 1}));
  EXPECT_EQ(cell_at({11, 8}), MapCell(4));
}

TEST_F(UiTurns, PastedTilesTurnBeforeTheyArePutDown) {
  click(on_sheet(3));
  key(kKeyF3);
  key('y');
  click(on_map({10, 8}));
  key('3');
  drag(on_map({10, 8}), on_map({10, 8}));
  click(on_map({10, 8}));
  key(ctrl('a'));
  key(ctrl('c'));
  key(ctrl('v'));
  ASSERT_TRUE(session().choices().pasted);
  key('y');
  const Stamp& pasted = *session().choices().pasted;
  EXPECT_EQ(pasted.at(10, pasted.h - 1 - 8), MapCell(3)) << "flipped twice";
}

// A slope that is flipped is a slope down for the ball.
TEST_F(UiTurns, TheGroundTurnsWithThePicture) {
  click(on_sheet(3));
  key(kKeyF3);
  key('x');
  click(on_map({12, 9}));
  const auto& items = session().scene().items;
  EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const SceneItem& item) {
    return item.cell.y == 9 && item.role != TileRole::ball;
  }));
}

}  // namespace talus::turns_ui_test
