// A cart with a companion: saved, named in the title, quit without a question, opened again.
#include <fstream>

#include "harness.h"

namespace talus::companion_ui_test {

class UiCompanion : public UiTest {
 protected:
  static std::string title() { return SDL_GetWindowTitle(SDL_GL_GetCurrentWindow()); }
  // Starts with a cart that needs no companion.
  void start_cart(const std::string& name) {
    Level level;
    level.map.set({12, 16}, 1);
    level.sheet(SheetId::tiles).flags[1] = 1;
    ASSERT_TRUE(save_level(level, *format_for_file(name), path(name)));
    start(path(name));
  }
};

TEST_F(UiCompanion, ABodyPlacedInACartSurvives) {
  for (const std::string name : {"game.tic", "game.lua", "game.yue"}) {
    start_cart(name);
    EXPECT_EQ(title(), name + " - Talus");
    key('0');
    click(on_map({12, 9}));
    frames(2);
    click("map/first_body_ball");
    ASSERT_EQ(level().spawns.size(), 1u);
    key(ctrl('s'));
    frames(2);
    EXPECT_EQ(title(), name + " + " + name + ".talus.json - Talus");
    EXPECT_EQ(session().message()->text, "Saved " + name + " + " + name + ".talus.json.");
    key(ctrl('q'));
    frames(2);
    EXPECT_FALSE(session().question());
    EXPECT_TRUE(session().wants_quit());
    start(path(name));
    EXPECT_EQ(level().spawns.size(), 1u);
    EXPECT_EQ(title(), name + " + " + name + ".talus.json - Talus");
    EXPECT_FALSE(session().message());
    drop(path(name + ".talus.json"));
    EXPECT_EQ(session().path(), path(name)) << "it opens its cart";
  }
}

TEST_F(UiCompanion, DroppedContentIsAskedAboutBeforeQuitting) {
  start_cart("game.tic");
  stop();
  std::ofstream(path("game.tic"), std::ios::binary | std::ios::app) << std::string("\x13\x01\0\0b", 5);
  start(path("game.tic"));
  key(ctrl_shift('s'));
  frames(2);
  click("files/name");
  key(ctrl('a'));
  type("game.lua");
  click("files/confirm");
  frames(2);
  ASSERT_EQ(session().path(), path("game.lua"));
  EXPECT_EQ(title(), "game.lua * - Talus");
  key(ctrl('q'));
  frames(2);
  ASSERT_TRUE(session().question());
  click("question/save");
  frames(2);
  ASSERT_NE(find("files/name"), nullptr);
  click("files/name");
  key(ctrl('a'));
  type("game.talus.json");
  click("files/confirm");
  EXPECT_TRUE(session().wants_quit());
}

}  // namespace talus::companion_ui_test
