// A map without ground says how to choose it, with a button that does.
#include <fstream>

#include "harness.h"

namespace talus::no_ground_test {

TEST_F(UiTest, AMapWithoutGroundOffersIt) {
  std::ofstream(path("plain.tmx"))
      << R"(<map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">)"
      << R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1">)"
      << R"(<image source="t.png" width="8" height="8"/></tileset>)"
      << R"(<layer name="l" width="2" height="1"><data encoding="csv">1,0</data></layer></map>)";
  start(path("plain.tmx"));
  frames(60 * 60);
  ASSERT_NE(find("message/ground"), nullptr) << "it waits";
  click("message/ground");
  frames(2);
  EXPECT_EQ(shape_of_tile(level(), tile_at({0, 0})).kind, TileShape::Kind::solid);
  EXPECT_EQ(find("message/ground"), nullptr);
  key(ctrl('z'));
  EXPECT_EQ(shape_of_tile(level(), tile_at({0, 0})).kind, TileShape::Kind::none);
}

}  // namespace talus::no_ground_test
