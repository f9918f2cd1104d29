// Flags: bytes, fields, the brush, and finding the cells with a flag.
#include <imgui_internal.h>

#include "edit/map_stroke.h"
#include "harness.h"

namespace talus::flags_test {

class UiFlags : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  FlagSet flags_of(int tile) { return level().tile_flags(static_cast<TileNumber>(tile)); }
  std::size_t edits() { return session().history().edits().size(); }
  void choose_tint(int item) {
    click("canvas/flag_tint");
    frames(2);
    click("canvas/flag_tint" + std::to_string(item));
    frames(2);
  }
  void make_field_of_flags_4_and_5() {
    click("flags/menu4");
    frames(2);
    click("flags/make_field");
    frames(2);
  }
};

constexpr KeyChord kReturn{'\r'}, kEscapeKey{27};

TEST_F(UiFlags, AllEightAreTypedAsAByte) {
  drag(on_sheet(20), on_sheet(21));
  click("flags/byte");
  type("a5");
  key(kReturn);
  EXPECT_EQ(flags_of(20), 0xa5);
  EXPECT_EQ(flags_of(21), 0xa5);
  EXPECT_EQ(edits(), 1u);
  frames(2);  // until the field no longer has the keys
  key(ctrl('z'));
  EXPECT_EQ(flags_of(20), 0);
}

TEST_F(UiFlags, AnEmptyByteChangesNothingAndSaysSo) {
  click(on_sheet(1));
  click("flags/byte");
  key(ctrl('a'));
  key(kKeyDelete);
  key(kReturn);
  EXPECT_EQ(flags_of(1), 1);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "\"\" is no number of flags: type two hexadecimal digits, 00 to ff.");
}

TEST_F(UiFlags, TheBrushSetsAndClearsOnTheSheet) {
  choose_tint(6);
  key(ctrl_shift('f'));
  EXPECT_EQ(session().choices().map_tool, MapTool::flag);
  drag(on_sheet(40), on_sheet(43));
  for (int tile = 40; tile <= 43; ++tile) EXPECT_EQ(flags_of(tile), 0x40) << tile;
  EXPECT_EQ(edits(), 1u) << "a stroke is one edit";
  drag(on_sheet(42), on_sheet(45));
  EXPECT_EQ(flags_of(41), 0x40);
  for (int tile = 42; tile <= 45; ++tile) EXPECT_EQ(flags_of(tile), 0) << tile;
  key(ctrl('z'));
  EXPECT_EQ(flags_of(42), 0x40);
  EXPECT_EQ(flags_of(44), 0);
}

TEST_F(UiFlags, TheBrushPaintsTheTilesOfTheMap) {
  choose_tint(7);
  click("flags/brush");
  drag(on_map({3, 16}), on_map({6, 16}));
  EXPECT_EQ(flags_of(1), 0x81) << "the floor's tile";
  EXPECT_EQ(tile_at({3, 16}), 1) << "the cells stay";
  EXPECT_EQ(edits(), 1u);
  click(on_map({20, 16}));
  EXPECT_EQ(flags_of(1), 0x01);
  click("flags/brush");
  EXPECT_EQ(session().choices().map_tool, MapTool::stamp);
}

TEST_F(UiFlags, AStrokeOverTheMapSkipsEmptyCells) {
  key(ctrl_shift('f'));
  drag(on_map({5, 10}), on_map({20, 16}));
  EXPECT_EQ(flags_of(2), 0x03) << "the drag began on the ball's tile";
  EXPECT_EQ(flags_of(1), 0x01) << "the floor's tile has the flag";
  EXPECT_EQ(flags_of(0), 0x00) << "the air between";
  session().apply(action::EditLevel{paint_stroke(level(), {8, 10}, {8, 10}, {8, 10}, {1, 1, {200}}, {})});
  drag(on_map({5, 10}), on_map({9, 10}));
  EXPECT_EQ(flags_of(2), 0x02);
  EXPECT_EQ(flags_of(200), 0x00) << "it has no picture either";
  click(on_map({8, 10}));
  EXPECT_EQ(flags_of(200), 0x01) << "on purpose";
  click(on_map({12, 10}));
  EXPECT_EQ(flags_of(0), 0x01);
}

TEST_F(UiFlags, EscapeUndoesAStroke) {
  choose_tint(6);
  key(ctrl_shift('f'));
  move(on_sheet(40));
  press();
  move(on_sheet(43));
  EXPECT_EQ(flags_of(43), 0x40);
  key(kEscapeKey);
  move(on_sheet(45));
  release();
  for (int tile = 40; tile <= 45; ++tile) EXPECT_EQ(flags_of(tile), 0) << tile;
  move(on_map({3, 16}));
  press();
  move(on_map({6, 16}));
  EXPECT_EQ(flags_of(1), 0x41);
  key(kEscapeKey);
  release();
  EXPECT_EQ(flags_of(1), 0x01);
  EXPECT_FALSE(session().history().can_undo());
}

TEST_F(UiFlags, TheRightButtonSelectsUnderTheBrush) {
  key(ctrl_shift('f'));
  EXPECT_EQ(session().choices().flag_overlay, pattern_of_flag(0)) << "it paints something from the start";
  click(on_sheet(77), kRight);
  EXPECT_EQ(session().choices().area.tile_at(level(), 0, 0), 77);
  EXPECT_EQ(flags_of(77), 0);
}

TEST_F(UiFlags, ALongNameCanBeRead) {
  const std::string name = "conveyor belt that runs to the left";
  click("flags/menu6");
  frames(2);
  type(name);
  key(kReturn);
  EXPECT_EQ(level().flag_names[6], name);
  const auto text_width = [&] { return ImGui::CalcTextSize(name.c_str()).x; };
  EXPECT_LT(find("flags/lamp6")->max.x - find("flags/lamp6")->min.x, text_width()) << "it does not fit there";
  const auto height_of_help = [&](const char* lamp) {
    move(centre(lamp));
    frames(90);
    const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
    return tooltip != nullptr && tooltip->Active ? tooltip->Size.y : 0;
  };
  EXPECT_GT(height_of_help("flags/lamp7"), 0);
  EXPECT_GT(height_of_help("flags/lamp6"), height_of_help("flags/lamp7"))
      << "one more line, with the flag's name";
  click("flags/menu6");
  frames(2);
  EXPECT_GT(find("flags/name")->max.x - find("flags/name")->min.x, text_width());
  EXPECT_EQ(ImGui::GetCurrentContext()->InputTextState.ScrollX, 0) << "its beginning is in sight";
}

TEST_F(UiFlags, FieldsAreMadeNamedAndChosen) {
  make_field_of_flags_4_and_5();
  ASSERT_EQ(level().flag_fields.size(), 1u);
  EXPECT_EQ(level().flag_fields[0], (FlagField{"", 4, 2, {}, ""}));
  click("flags/field_name");
  type("ground");
  click("flags/value2");
  type("ice");
  EXPECT_EQ(level().flag_fields[0].name, "ground");
  EXPECT_EQ(level().flag_fields[0].values, (std::vector<std::string>{"", "", "ice"}));
  EXPECT_EQ(edits(), 3u) << "what is typed in a field is one edit";
  key(kEscapeKey);
  frames(2);
  EXPECT_EQ(find("flags/lamp4"), nullptr);
  ASSERT_NE(find("flags/lamp6"), nullptr);
  drag(on_sheet(30), on_sheet(31));
  click("flags/field4");
  frames(2);
  click("flags/choice2");
  EXPECT_EQ(flags_of(30), 0x20);
  EXPECT_EQ(flags_of(31), 0x20);
  key(ctrl('z'));
  EXPECT_EQ(flags_of(31), 0);
}

TEST_F(UiFlags, FieldsAreExtendedAndRemoved) {
  make_field_of_flags_4_and_5();
  click("flags/field_wider");
  frames(2);
  click("flags/field_wider");
  frames(2);
  EXPECT_EQ(level().flag_fields[0].bits, 4);
  EXPECT_FALSE(find("flags/field_wider")->enabled) << "flag 7 is the last";
  click("flags/field_narrower");
  frames(2);
  EXPECT_EQ(level().flag_fields[0].bits, 3);
  click("flags/part5");
  frames(2);
  click("flags/role_one_way");
  frames(2);
  EXPECT_EQ(level().roles.one_way, 5) << "flags of a field have roles of their own";
  click("flags/to_field");
  frames(2);
  click("flags/remove_field");
  frames(2);
  EXPECT_TRUE(level().flag_fields.empty());
  EXPECT_NE(find("flags/lamp4"), nullptr);
  key(ctrl('z'));
  EXPECT_EQ(level().flag_fields.size(), 1u);
}

TEST_F(UiFlags, TheListGoesFromCellToCell) {
  key(alt('g'));
  frames(3);
  click("flag_search/flag");
  frames(2);
  click("flag_search/flag1");  // the flag of balls, which one cell has
  frames(2);
  ASSERT_NE(find("flag_search/tile2"), nullptr);
  EXPECT_EQ(find("flag_search/tile1"), nullptr);
  click("flag_search/next");
  frames(2);
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{5, 10}));
  click("flag_search/flag");
  frames(2);
  click("flag_search/flag0");
  frames(2);
  key(ctrl('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{0, 16}));
  key(ctrl('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{1, 16}));
  key(ctrl_shift('g'));
  key(ctrl_shift('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{29, 16})) << "around the end";
  click("flag_search/tile1");
  EXPECT_EQ(session().choices().area.tile_at(level(), 0, 0), 1);
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{0, 16}));
}

}  // namespace talus::flags_test
