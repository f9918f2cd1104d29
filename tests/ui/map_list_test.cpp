// Folders and several maps: the next one with one key.
#include <filesystem>
#include <fstream>

#include "harness.h"

namespace talus::map_list_test {

class UiMapList : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    std::filesystem::create_directories(path("maps/inner"));
    for (const char* name : {"maps/b.talus.json", "maps/c.talus.json", "maps/inner/d.talus.json"})
      std::filesystem::copy_file(save_test_level("one.talus.json"), path(name));
    std::ofstream(path("maps/a.tmx"))
        << R"(<map orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)"
        << R"(<layer name="l" width="1" height="1"><data encoding="csv">0</data></layer></map>)";
    std::ofstream(path("maps/notes.txt")) << "no map";
    std::ofstream(path("maps/broken.tmx")) << "no map either";
  }
};

constexpr KeyChord kNext = ctrl(kKeyPageDown), kPrevious = ctrl(kKeyPageUp);

TEST_F(UiMapList, AFolderIsGoneThroughByKeys) {
  drop(path("maps"));
  ASSERT_TRUE(frames_until([&] { return !session().maps().files().empty(); }));
  EXPECT_EQ(session().maps().files().size(), 5u) << "with that in the inner folder, without notes.txt";
  EXPECT_EQ(session().path(), path("maps/a.tmx"));
  key(kNext);
  EXPECT_EQ(session().path(), path("maps/b.talus.json"));
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Map 2 of 5: b.talus.json.");
  key(kNext);
  EXPECT_EQ(session().path(), path("maps/b.talus.json")) << "broken.tmx cannot be opened";
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  key(kNext);
  EXPECT_EQ(session().path(), path("maps/c.talus.json"));
  key(kNext);
  EXPECT_EQ(session().path(), path("maps/inner/d.talus.json"));
  key(kNext);
  EXPECT_EQ(session().path(), path("maps/a.tmx")) << "in a circle";
  key(kPrevious);
  EXPECT_EQ(session().path(), path("maps/inner/d.talus.json"));
}

TEST_F(UiMapList, SeveralMapsAreListedInTheMenu) {
  drop_all({path("maps/c.talus.json"), path("maps/b.talus.json")});
  EXPECT_EQ(session().path(), path("maps/b.talus.json"));
  EXPECT_EQ(session().maps().files().size(), 2u);
  click("menu/File");
  click("menu/maps");
  click("menu/maps1");
  EXPECT_EQ(session().path(), path("maps/c.talus.json"));
}

TEST_F(UiMapList, UnsavedChangesAreAskedAboutFirst) {
  drop(path("maps/b.talus.json"));
  click(on_sheet(1));
  click(on_map({12, 9}));
  ASSERT_TRUE(session().modified());
  key(kNext);
  ASSERT_TRUE(frames_until([&] { return session().question().has_value(); }));
  frames(3);
  EXPECT_EQ(session().path(), path("maps/b.talus.json"));
  click("question/cancel");
  EXPECT_EQ(tile_at({12, 9}), 1);
  key(kNext);
  click("question/discard");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 1) << "broken.tmx cannot be opened, so the level stays";
  key(kNext);
  click("question/discard");
  frames(2);
  EXPECT_EQ(session().path(), path("maps/c.talus.json")) << "from the folder of the file";
}

}  // namespace talus::map_list_test
