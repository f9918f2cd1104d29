// Many events before one frame, as slow frames get them.
#include "harness.h"

namespace talus::burst_test {

using UiBurst = UiTest;

constexpr KeyChord kEnter{'\r'}, kLeftArrow{kKeyLeft}, kDel{kKeyDelete};

TEST_F(UiBurst, NameIsTypedInAFewFrames) {
  start();
  click("flags/menu5");
  frames(2);
  push_typing("twenty letters right");
  push_stroke(kEnter);
  for (int i = 0; i < 3; ++i) app().frame();
  EXPECT_EQ(level().flag_names[5], "twenty letters right");
  EXPECT_FALSE(app().has_waiting_events());
}

TEST_F(UiBurst, EditingKeysKeepTheirPlaceBetweenLetters) {
  start();
  click("flags/menu5");
  frames(2);
  push_typing("ab");
  push_stroke(kLeftArrow);
  push_typing("cd");
  push_stroke(kDel);
  push_typing("e");
  push_stroke(kEnter);
  frames(2);
  EXPECT_EQ(level().flag_names[5], "acde");
}

TEST_F(UiBurst, DialogTakesTypedTextAndNotTheClickAfterIt) {
  start();
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), path("second.talus.json")));
  click(on_sheet(3));
  const ImVec2 cell = on_map({12, 9});
  push_stroke(ctrl('o'));
  push_typing("second.talus.json");
  push_stroke(kEnter);
  push_click(cell);
  frames(2);
  EXPECT_EQ(session().path(), path("second.talus.json"));
  EXPECT_EQ(tile_at({1, 1}), 6);
  EXPECT_EQ(tile_at({12, 9}), 3);
}

TEST_F(UiBurst, ShortClicksAndStrokesAreAllSeen) {
  start();
  click(on_sheet(1));
  const ImVec2 first = on_map({3, 3}), second = on_map({5, 3});
  push_click(first);
  push_click(second);
  for (int i = 0; i < 3; ++i) push_stroke(KeyChord{kKeyF10});
  push_stroke(ctrl('z'));
  frames(2);
  EXPECT_EQ(tile_at({3, 3}), 1);
  EXPECT_EQ(tile_at({5, 3}), 0);
  EXPECT_EQ(session().state().frame, 3);
}

}  // namespace talus::burst_test
