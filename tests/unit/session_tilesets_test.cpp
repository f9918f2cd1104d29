// A session saves a map of Tiled with its tileset, which other programs may change, too.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "session/session.h"

namespace talus::session_tilesets_test {

using testing::HasSubstr;

const std::string kMap =
    "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">\n <tileset "
    "firstgid=\"1\" source=\"t.tsx\"/>\n <layer name=\"l\"><data encoding=\"csv\">2</data></layer>\n</map>\n";
const std::string kTileset =
    "<tileset name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" columns=\"2\">\n</tileset>\n";

class SessionTilesets : public FolderTest {
 protected:
  void SetUp() override {
    put("a.tmx", kMap);
    put("t.tsx", kTileset);
    session_.apply(action::OpenFile{path("a.tmx")});
    ASSERT_EQ(session_.path(), path("a.tmx"));
  }
  void make_solid() {
    auto changed = std::make_shared<Level>(session_.level());
    const TileNumber tile = changed->map.tile_at({0, 0});
    changed->sheet(SheetId::tiles).flags[tile] = 1;
    session_.apply(action::EditLevel{replace_by(session_.level(), changed, "Change flags")});
  }
  Session session_;
};

TEST_F(SessionTilesets, SavingNamesTheFilesThatItWrites) {
  make_solid();
  session_.apply(action::SaveFile{});
  ASSERT_TRUE(session_.message());
  EXPECT_EQ(session_.message()->text, "Saved a.tmx + t.tsx.");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("name=\"solid\" type=\"bool\" value=\"true\""));
  EXPECT_EQ(bytes_of("a.tmx"), kMap);
  session_.apply(action::SaveFile{});
  EXPECT_EQ(session_.message()->text, "Saved a.tmx.");
}

TEST_F(SessionTilesets, AChangedTilesetIsMergedFirst) {
  make_solid();
  std::string changed = kTileset;
  changed.replace(changed.find("name=\"t\""), 8, "name=\"u\"");
  put("t.tsx", changed);
  session_.apply(action::SaveFile{});
  EXPECT_FALSE(session_.question());
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("name=\"u\""));
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("name=\"solid\""));
  EXPECT_FALSE(session_.modified());
}

TEST_F(SessionTilesets, ACopyAsksAboutAChangedTileset) {
  session_.apply(action::SaveFileAs{path("b.tmx")});
  make_solid();
  std::string changed = kTileset;
  changed.replace(changed.find("name=\"t\""), 8, "name=\"u\"");
  put("t.tsx", changed);
  session_.apply(action::SaveFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_THAT(session_.question()->text, HasSubstr("t.tsx was changed by another program"));
  EXPECT_EQ(bytes_of("t.tsx"), changed);
  session_.apply(action::AnswerQuestion{action::Answer::keep});
  session_.apply(action::SaveFile{});
  EXPECT_FALSE(session_.question());
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("name=\"solid\""));
}

}  // namespace talus::session_tilesets_test
