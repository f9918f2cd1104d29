// Brushes, random tiles and the ground tool, by hand.
#include "edit/brush_tools.h"
#include "harness.h"

namespace talus::brushes_ui_test {

class UiBrushes : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    key(kKeyF3);
    key(ctrl('1'));
  }
  std::string row(int y, int from, int count) {
    std::string text;
    for (int x = from; x < from + count; ++x) text += std::to_string(tile_at({x, y})) + " ";
    return text;
  }
  const std::vector<Brush>& brushes() { return level().brushes; }
};

TEST_F(UiBrushes, AStampIsSavedUsedRenamedAndDeleted) {
  drag(on_sheet(3), on_sheet(4));
  click("tabs/brushes");
  click("brushes/add_button");
  ASSERT_EQ(brushes().size(), 1u);
  EXPECT_EQ(brushes()[0], (Brush{"Brush 1", 2, 1, {3, 4}, false, {}}));

  click(on_sheet(1));
  EXPECT_EQ(session().choices().stamp, (Stamp{1, 1, {1}}));
  click("brushes/0/take");
  EXPECT_EQ(session().choices().stamp, (Stamp{2, 1, {3, 4}}));
  EXPECT_EQ(session().choices().map_tool, MapTool::stamp);

  click("brushes/0/name");
  key(ctrl('a'));
  type("ramp");
  EXPECT_EQ(brushes()[0].name, "Brush 1") << "the name does not change while it is typed";
  key('\r');
  EXPECT_EQ(brushes()[0].name, "ramp");

  click("brushes/0/delete");
  EXPECT_TRUE(brushes().empty());
  key(ctrl('z'));
  ASSERT_EQ(brushes().size(), 1u);
  EXPECT_EQ(brushes()[0].name, "ramp");
}

TEST_F(UiBrushes, ARandomStampPaintsTheTilesOfItsCells) {
  drag(on_sheet(3), on_sheet(6));
  key(kKeyF3);
  key('d');
  EXPECT_TRUE(session().choices().random_stamp);
  const Stamp stamp = session().choices().stamp;
  drag(on_map({2, 3}), on_map({12, 3}));
  for (int x = 2; x <= 12; ++x) EXPECT_EQ(tile_at({x, 3}), random_tile(stamp, {x, 3}, 1)) << x;
  EXPECT_EQ(tile_at({13, 3}), 0) << "a cell at a time, though the stamp is wide";
  const std::string painted = row(3, 2, 11);
  key(ctrl('z'));
  EXPECT_EQ(tile_at({5, 3}), 0);
  key(ctrl('y'));
  EXPECT_EQ(row(3, 2, 11), painted);

  key(shift('d'));
  drag(on_map({2, 3}), on_map({12, 3}));
  EXPECT_NE(row(3, 2, 11), painted) << "another seed";
}

TEST_F(UiBrushes, GroundIsProposedPaintedAndRemoved) {
  key(shift('g'));
  const AutoTiles& set = level().auto_tiles;
  EXPECT_EQ(set.of(GroundPart::inside), 1);
  EXPECT_EQ(set.of(GroundPart::slope_up_left), 3);
  EXPECT_EQ(set.of(GroundPart::slope_up_right), 4);
  key(kKeyF3);
  key('g');
  EXPECT_EQ(session().choices().map_tool, MapTool::ground);
  drag(on_map({8, 15}), on_map({15, 15}));
  EXPECT_EQ(row(15, 7, 10), "0 3 4 1 1 1 1 5 6 0 ") << "slopes where the floor below goes on";
  drag(on_map({10, 14}), on_map({13, 14}));
  EXPECT_EQ(row(14, 9, 6), "0 3 4 5 6 0 ");
  hold_modifiers(ctrl(0));
  click(on_map({13, 14}));
  hold_modifiers({});
  EXPECT_EQ(row(14, 9, 6), "0 1 1 1 0 0 ") << "three cells have no room for two long slopes";
  key(ctrl('z'));
  EXPECT_EQ(row(14, 9, 6), "0 3 4 5 6 0 ");
}

TEST_F(UiBrushes, AGroundRectangleIsFilledWithShift) {
  key(shift('g'));
  key('g');
  hold_modifiers(shift(0));
  drag(on_map({3, 3}), on_map({5, 4}));
  hold_modifiers({});
  EXPECT_EQ(row(3, 2, 5) + row(4, 2, 5), "0 1 1 1 0 0 1 1 1 0 ");
}

TEST_F(UiBrushes, WithoutTilesForGroundTheToolSaysWhatToDo) {
  key('g');
  click(on_map({3, 3}));
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_FALSE(session().modified());
  frames(3);
  EXPECT_NE(find("ground/inside"), nullptr) << "the panel came to the front";
}

TEST_F(UiBrushes, APartIsChosenFromTheSheetAndCleared) {
  click("tabs/brushes");
  click(on_sheet(3));
  click("ground/slope_up_left");
  EXPECT_EQ(level().auto_tiles.of(GroundPart::slope_up_left), 3);
  click("ground/slope_up_left", kRight);
  EXPECT_TRUE(level().auto_tiles.empty());
  key(ctrl('z'));
  EXPECT_EQ(level().auto_tiles.of(GroundPart::slope_up_left), 3);
}

}  // namespace talus::brushes_ui_test
