// The question about an edit that the open map of Tiled cannot hold, as the user sees it.
#include <fstream>

#include "harness.h"

namespace talus::beyond_file_ui_test {

// A map of 3x2 cells with a layer of 4x2 cells: in another size, the tiles off the map would be lost.
class UiBeyondFile : public UiTest {
 protected:
  void open_map() {
    std::ofstream(path("m.tmx"))
        << R"(<map orientation="orthogonal" width="3" height="2" tilewidth="8" tileheight="8">)"
           R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="6" columns="3"/>)"
           R"(<layer name="a" width="4" height="2"><data encoding="csv">1,2,3,4,5,6,1,2</data></layer></map>)";
    start(path("m.tmx"), 1152, 700);
    frames(3);
    ASSERT_EQ(level().map.width(), 3);
  }
  void widen() {
    key(ctrl('e'));
    frames(3);
    click("resize/width");
    key(ctrl('a'));
    type("5");
    key(kKeyTab);
    frames(2);
    click("resize/apply");
    frames(3);
  }
};

TEST_F(UiBeyondFile, CancelAndEscapeLeaveTheLevelAsItWas) {
  open_map();
  widen();
  ASSERT_NE(find("question/text"), nullptr);
  click("question/cancel");
  frames(2);
  EXPECT_EQ(level().map.width(), 3);
  widen();
  ASSERT_NE(find("question/text"), nullptr);
  key(kKeyEscape);
  frames(2);
  EXPECT_FALSE(session().question());
  EXPECT_EQ(level().map.width(), 3);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiBeyondFile, EditAnywayMakesItAndUndoTakesItBack) {
  open_map();
  widen();
  click("question/edit");
  frames(2);
  EXPECT_EQ(level().map.width(), 5);
  key(ctrl('z'));
  frames(2);
  EXPECT_EQ(level().map.width(), 3);
}

TEST_F(UiBeyondFile, SaveAsAsksForAName) {
  open_map();
  widen();
  click("question/save");
  frames(3);
  EXPECT_EQ(level().map.width(), 5);
  EXPECT_NE(find("files/name"), nullptr) << "the dialog that saves";
}

}  // namespace talus::beyond_file_ui_test
