// The dialog that asks which part of a map of Tiled becomes the level.
#include <fstream>

#include "harness.h"

namespace talus::level_import_test {

class UiLevelImport : public UiTest {
 protected:
  // Writes a map of three layers. The second has the most tiles, and one of them is mirrored. The third is of
  // a tileset that is too large.
  std::string save_map() {
    std::ofstream(path("big.tmx"))
        << R"(<map orientation="orthogonal" width="3" height="1" tilewidth="8" tileheight="8">)"
           R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="16" columns="16"/>)"
           R"(<tileset firstgid="1000" name="u" tilewidth="8" tileheight="8" tilecount="70000" columns="16"/>)"
           R"(<layer name="sky"><data encoding="csv">3,0,0</data></layer>)"
           R"(<layer name="ground"><data encoding="csv">2147483654,6,0</data></layer>)"
           R"(<layer name="sky"><data encoding="csv">1000,0,0</data></layer></map>)";
    return path("big.tmx");
  }
  void press_key(int key_code) {
    key(key_code);
    frames(3);
  }
  void press_letter(char letter) {
    push_typing(std::string(1, letter));
    frames(4);
  }
  const LevelImport& import() { return *session().level_import(); }
};

TEST_F(UiLevelImport, TheLayerIsChosenByTheMouse) {
  start();
  drop(save_map());
  frames(3);
  ASSERT_TRUE(session().level_import());
  EXPECT_EQ(import().choices, ImportChoices{.used_tiles = true});
  ASSERT_NE(find("choose/report"), nullptr) << "it can be opened at once";
  click("choose/layer3");
  click("choose/all_tiles");
  frames(2);
  ASSERT_NE(find("choose/error"), nullptr);
  EXPECT_FALSE(find("choose/open")->enabled);
  click("choose/layer1");
  frames(2);
  EXPECT_NE(find("choose/report"), nullptr);
  click("choose/open");
  frames(3);
  EXPECT_EQ(find("choose/open"), nullptr);
  EXPECT_EQ(tile_at({0, 0}), 2) << "the number of a tile of Tiled counts from 1";
  EXPECT_EQ(session().path(), path("big.tmx")) << "saving goes into the map";
}

TEST_F(UiLevelImport, TheLayerIsChosenByKeys) {
  start(save_map());
  frames(3);
  ASSERT_NE(find("choose/open"), nullptr) << "the program's argument is asked about, too";
  for (int i = 0; i < 2; ++i) press_key(kKeyUp);  // to all tiles
  press_key(' ');
  ASSERT_NE(find("choose/error"), nullptr);
  press_letter('o');
  ASSERT_NE(find("choose/open"), nullptr) << "it cannot be opened so";
  for (int i = 0; i < 3; ++i) press_key(kKeyUp);
  press_key(' ');
  EXPECT_EQ(import().choices, (ImportChoices{.layer_number = 1}));
  press_key(kKeyDown);
  press_key(' ');
  for (int i = 0; i < 3; ++i) press_key(kKeyDown);
  press_key(' ');
  EXPECT_EQ(import().choices, (ImportChoices{.layer_number = 2, .used_tiles = true}));
  press_letter('o');
  EXPECT_EQ(find("choose/open"), nullptr);
  EXPECT_EQ(level().map.width(), 3);
  EXPECT_EQ(tile_at({1, 0}), 1);
  EXPECT_EQ(level().map.at({0, 0}), MapCell(1, TileTurn::left_right));
}

TEST_F(UiLevelImport, EnterAcceptsTheProposal) {
  start(save_map());
  frames(3);
  press_key(kKeyEnter);
  EXPECT_EQ(find("choose/open"), nullptr);
  EXPECT_EQ(level().map.width(), 3);
}

TEST_F(UiLevelImport, EscapeGoesBack) {
  start();
  const Level before = level();
  drop(save_map());
  frames(3);
  ASSERT_NE(find("choose/cancel"), nullptr);
  key(kKeyEscape);
  frames(3);
  EXPECT_EQ(find("choose/cancel"), nullptr);
  EXPECT_TRUE(level() == before);
}

// A project of LDtk with two levels side by side, of 8 and 16 px.
class UiLdtkImport : public UiLevelImport {
 protected:
  std::string save_project() {
    const auto level = [](const char* name, int x, int columns, const char* values) {
      const std::string cells = std::to_string(columns);
      return std::string(R"({"identifier":")") + name + R"(","worldX":)" + std::to_string(x) +
             R"(,"worldY":0,"pxWid":)" + std::to_string(8 * columns) +
             R"(,"pxHei":8,"layerInstances":[{"__identifier":"G","__type":"IntGrid","__cWid":)" + cells +
             R"(,"__cHei":1,"__gridSize":8,"intGridCsv":[)" + values + "]}]}";
    };
    std::ofstream(path("game.ldtk")) << R"({"defs":{"layers":[],"tilesets":[]},"levels":[)"
                                     << level("Cave", 0, 1, "1") << "," << level("Top", 8, 2, "1,1") << "]}";
    return path("game.ldtk");
  }
};

TEST_F(UiLdtkImport, ALevelIsChosenInThePictureOfTheWorld) {
  start();
  drop(save_project());
  frames(3);
  ASSERT_TRUE(session().level_import());
  EXPECT_EQ(import().choices.level_number, 1);
  EXPECT_EQ(find("choose/used_tiles"), nullptr) << "that is a question about maps of Tiled";
  click("choose/world/level2");
  frames(2);
  EXPECT_EQ(import().choices.level_number, 2);
  click("choose/open");
  frames(3);
  EXPECT_EQ(level().map.width(), 2);
  EXPECT_EQ(session().path(), path("game.ldtk"));
}

TEST_F(UiLdtkImport, ALevelIsChosenInTheList) {
  start(save_project());
  frames(3);
  ASSERT_NE(find("choose/level2"), nullptr);
  click("choose/level2");
  frames(2);
  press_key(kKeyEnter);
  EXPECT_EQ(level().map.width(), 2);
}

TEST_F(UiLdtkImport, ValuesAreMappedAndMappedAgain) {
  std::ofstream(path("one.ldtk"))
      << R"({"defs":{"layers":[{"uid":1,"identifier":"G","intGridValues":[{"value":1,"identifier":"wall"}]}],)"
         R"("tilesets":[]},"levels":[{"identifier":"L","pxWid":16,"pxHei":8,"layerInstances":[)"
         R"({"__identifier":"G","__type":"IntGrid","__cWid":2,"__cHei":1,"__gridSize":8,"layerDefUid":1,)"
         R"("intGridCsv":[1,0]}]}]})";
  start(path("one.ldtk"));
  frames(3);
  ASSERT_NE(find("choose/thing1/shape"), nullptr) << "nothing is remembered";
  click("choose/thing1/shape");
  frames(2);
  click("choose/thing1/shape/slope_up");
  frames(3);
  click("choose/open");
  frames(3);
  EXPECT_EQ(shape_of_tile(level(), 1).heights, (std::vector<double>{0, 8}));
  EXPECT_FALSE(session().modified());
  session().apply(action::OpenFile{path("one.ldtk")});
  frames(3);
  EXPECT_EQ(find("choose/open"), nullptr) << "the mapping is remembered without saving";
  EXPECT_EQ(shape_of_tile(level(), 1).heights, (std::vector<double>{0, 8}));
  session().apply(action::SaveFile{});
  frames(2);
  session().apply(action::OpenFile{path("one.ldtk")});
  frames(3);
  EXPECT_EQ(find("choose/open"), nullptr) << "the mapping is remembered beside the project";
  EXPECT_EQ(shape_of_tile(level(), 1).heights, (std::vector<double>{0, 8}));
  session().apply(action::EditLevel{{"Paint", {CellChange{{1, 0}, 0, 1}}}});
  session().apply(action::AskLdtkMapping{});
  frames(3);
  click("choose/thing1/shape");
  frames(2);
  click("choose/thing1/shape/usual");
  frames(3);
  click("choose/open");
  frames(3);
  EXPECT_EQ(shape_of_tile(level(), 1).kind, TileShape::Kind::solid);
  EXPECT_EQ(tile_at({1, 0}), 1) << "what was painted stays";
  session().apply(action::Undo{});
  EXPECT_EQ(shape_of_tile(level(), 1).heights, (std::vector<double>{0, 8}));
}

}  // namespace talus::level_import_test
