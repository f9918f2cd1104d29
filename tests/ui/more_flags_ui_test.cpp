// The flags panel of levels with more than the eight flags of a cart.
#include <imgui_internal.h>

#include <ostream>

#include "harness.h"
#include "panels/tiles/flag_label.h"

namespace talus::more_flags_ui_test {

constexpr KeyChord kReturn{'\r'};

class UiMoreFlags : public UiTest {
 protected:
  FlagSet flags_of(int tile) { return level().tile_flags(static_cast<TileNumber>(tile)); }
  void start_with(const Level& level, int width = 1152, int height = 700) {
    ASSERT_TRUE(save_level(level, *find_format("native"), path("flags.talus.json")));
    start(path("flags.talus.json"), width, height);
  }
  static Level level_of_20() {
    Level level = test_level();
    for (std::size_t flag = 4; flag < 20; ++flag) level.flag_names[flag] = "mark " + std::to_string(flag);
    return level;
  }
  bool is_in_sight(const std::string& name) {
    const Widget* widget = find(name);
    return widget != nullptr && widget->min.y >= widget->clip_min.y && widget->max.y <= widget->clip_max.y;
  }
  // Turns the wheel over the lamps, first down and then up.
  void bring_into_sight(const std::string& name) {
    ImVec2 lamps = centre("flags/brush");
    lamps.y += 40;
    move(lamps);
    for (int turn = 0; turn < 40 && !is_in_sight(name); ++turn) {
      wheel(turn < 20 ? -1 : 1);
      frames(4);
    }
    ASSERT_TRUE(is_in_sight(name)) << name;
  }
};

TEST_F(UiMoreFlags, ACartHasEightLampsAndNoMore) {
  Level cart = test_level();
  cart.map = TileMap();
  ASSERT_TRUE(save_level(cart, *find_format("tic"), path("a.tic")));
  start(path("a.tic"), 1152, 700);
  EXPECT_TRUE(is_in_sight("flags/lamp7"));
  EXPECT_EQ(find("flags/lamp8"), nullptr);
  EXPECT_EQ(find("flags/more"), nullptr);
}

TEST_F(UiMoreFlags, PlusNamesTheNextAndShowsEightMore) {
  start();
  EXPECT_EQ(find("flags/lamp8"), nullptr);
  click("flags/more");
  frames(2);
  type("lava");
  key(kReturn);
  frames(2);
  EXPECT_EQ(level().flag_names[8], "lava");
  EXPECT_EQ(shown_flags(level()), 16);
  click(on_sheet(20));
  bring_into_sight("flags/lamp15");
  bring_into_sight("flags/lamp8");
  click("flags/lamp8");
  EXPECT_EQ(flags_of(20), flag_bit(8));
  frames(2);
  key(ctrl('z'));
  key(ctrl('z'));
  frames(2);
  EXPECT_EQ(shown_flags(level()), 8) << "nothing uses them any more";
}

struct PanelSize {
  int width, height;
  friend void PrintTo(const PanelSize& size, std::ostream* out) { *out << size.width << "x" << size.height; }
};
class UiMoreFlagsAtSizes : public UiMoreFlags, public ::testing::WithParamInterface<PanelSize> {};

TEST_P(UiMoreFlagsAtSizes, EveryLampComesIntoSightByTheWheel) {
  start_with(level_of_20(), GetParam().width, GetParam().height);
  click(on_sheet(20));
  for (int flag = 0; flag < 24; ++flag) {
    const std::string name = "flags/lamp" + std::to_string(flag);
    bring_into_sight(name);
    click(name);
    EXPECT_EQ(flags_of(20), flag_bit(flag)) << flag;
    click(name);
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, UiMoreFlagsAtSizes,
                         ::testing::Values(PanelSize{1152, 700}, PanelSize{1920, 1080}));

TEST_F(UiMoreFlags, TheHeaderFitsBesideTheTabs) {
  for (const int flag : {7, 8, 16, 31}) {
    Level level = test_level();
    level.flag_names[static_cast<std::size_t>(flag)] = "last";
    start_with(level);
    const Widget *tab = find("tabs/color"), *brush = find("flags/brush"), *number = find("flags/byte");
    ASSERT_TRUE(brush != nullptr && number != nullptr);
    const Widget* const first = find("flags/more") != nullptr ? find("flags/more") : brush;
    if (tab != nullptr) {
      EXPECT_LE(tab->max.x, first->min.x) << flag;
    }
    EXPECT_LE(brush->max.x, number->min.x) << flag;
    EXPECT_LE(number->max.x, number->clip_max.x) << flag;
    const float digits = ImGui::CalcTextSize("88888888").x / 8 * static_cast<float>(shown_flags(level)) / 4;
    EXPECT_GE(number->max.x - number->min.x, digits) << flag << ": all digits are seen";
  }
}

TEST_F(UiMoreFlags, AllAreTypedAsANumber) {
  Level level = test_level();
  level.flag_names[31] = "last";
  start_with(level);
  click(on_sheet(20));
  click("flags/byte");
  type("80000101");
  key(kReturn);
  EXPECT_EQ(flags_of(20), 0x80000101);
}

TEST_F(UiMoreFlags, AFieldMayReachOverThem) {
  start_with(level_of_20());
  move(centre("flags/lamp0"));
  click("flags/menu7");
  frames(2);
  click("flags/make_field");
  frames(2);
  ASSERT_EQ(level().flag_fields.size(), 1u);
  EXPECT_EQ(level().flag_fields[0].last(), 8);
}

}  // namespace talus::more_flags_ui_test
