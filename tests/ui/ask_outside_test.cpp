// The question about files outside of a map's folder, as the user sees it.
#include <fstream>

#include "harness.h"

namespace talus::ask_outside_test {

class UiOutsideFiles : public UiTest {
 protected:
  // A map with that many pictures beside its folder, none of which is there.
  std::string put_map(int pictures) {
    std::filesystem::create_directories(path("maps"));
    std::string tilesets;
    for (int i = 0; i < pictures; ++i)
      tilesets +=
          "<tileset firstgid=\"" + std::to_string(i + 1) +
          R"(" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="../tiles/a)" +
          std::to_string(i) + R"(.png" width="8" height="8"/></tileset>)";
    std::ofstream(path("maps/cave.tmx"))
        << R"(<map orientation="orthogonal" width="3" height="1" tilewidth="8" tileheight="8">)" << tilesets
        << R"(<layer id="1" name="l"><data encoding="csv">1,1,1</data></layer></map>)";
    return path("maps/cave.tmx");
  }
};

TEST_F(UiOutsideFiles, AreAskedAboutBeforeTheMapOpens) {
  start(put_map(1), 1152, 700);
  frames(3);
  ASSERT_NE(find("question/read"), nullptr);
  EXPECT_EQ(session().path(), "");
  key(kKeyEnter);  // Enter does not read
  frames(3);
  EXPECT_FALSE(session().question());
  EXPECT_EQ(session().path(), path("maps/cave.tmx"));
  ASSERT_TRUE(session().message());
  EXPECT_NE(session().message()->text.find("../tiles/a0.png"), std::string::npos);
}

TEST_F(UiOutsideFiles, ReadOpensTheMapWithThem) {
  start();
  drop(put_map(9));
  frames(3);
  ASSERT_NE(find("question/text"), nullptr);
  EXPECT_NE(session().question()->text.find("and 3 more"), std::string::npos);
  push_typing("r");
  frames(4);
  EXPECT_FALSE(session().question());
  EXPECT_EQ(session().path(), path("maps/cave.tmx"));
  ASSERT_TRUE(session().message()) << "they do not exist";
  EXPECT_EQ(session().message()->text.find("lies outside"), std::string::npos);
}

}  // namespace talus::ask_outside_test
