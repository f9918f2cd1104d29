// A map of Tiled in the editor: saving goes into its own file.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "ldtk_text.h"
#include "session/session.h"
#include "tiled_files.h"

namespace talus::session_import_test {

class SessionImportTest : public FolderTest {};

TEST_F(SessionImportTest, AMapIsSavedIntoItsFile) {
  const Exported exported = tiled_export_of(level_for_tiled(), "tmj", "cave.tmj");
  ASSERT_TRUE(write_exported(*find_exporter("tmj"), exported, path("cave.tmj")));
  Session session;
  session.apply(action::OpenFile{path("cave.tmj")});
  EXPECT_TRUE(session.level() == level_for_tiled());
  EXPECT_EQ(session.path(), path("cave.tmj"));
  EXPECT_FALSE(session.message());
  session.apply(action::SaveFile{});
  EXPECT_EQ(bytes_of("cave.tmj"), exported.files[0].bytes);
  session.apply(action::EditLevel{{"Paint", {CellChange{{0, 0}, 0, 4}}}});
  session.apply(action::SaveFile{});
  EXPECT_FALSE(session.wants_save_as());
  EXPECT_FALSE(session.modified());
  EXPECT_NE(bytes_of("cave.tmj"), exported.files[0].bytes);
  EXPECT_FALSE(exists("cave.tmj.talus.json"));
  const auto again = load_level(path("cave.tmj"));
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->level == session.level());
}

TEST_F(SessionImportTest, AMapThatAnotherProgramChangedIsMergedFirst) {
  const Exported exported = tiled_export_of(level_for_tiled(), "tmj", "cave.tmj");
  ASSERT_TRUE(write_exported(*find_exporter("tmj"), exported, path("cave.tmj")));
  Session session;
  session.apply(action::OpenFile{path("cave.tmj")});
  session.apply(action::EditLevel{{"Paint", {CellChange{{0, 0}, 0, 4}}}});
  put("cave.tmj", exported.files[0].bytes + "\n");
  session.apply(action::SaveFile{});
  EXPECT_FALSE(session.question());
  EXPECT_FALSE(session.modified());
  const std::string saved = bytes_of("cave.tmj");
  EXPECT_TRUE(saved.ends_with("\n\n")) << "what the other program wrote stays";
  EXPECT_NE(saved, exported.files[0].bytes + "\n") << "so does what was painted here";
}

TEST_F(SessionImportTest, AMapCanBeSavedAsALevel) {
  const Exported exported = tiled_export_of(level_for_tiled(), "tmj", "cave.tmj");
  ASSERT_TRUE(write_exported(*find_exporter("tmj"), exported, path("cave.tmj")));
  Session session;
  session.apply(action::OpenFile{path("cave.tmj")});
  session.apply(action::SaveFileAs{path("cave.talus.json")});
  EXPECT_EQ(session.path(), path("cave.talus.json"));
  session.apply(action::NewLevel{});
  session.apply(action::SaveFileAs{path("new.tmj")});
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_THAT(session.message()->text, testing::HasSubstr("only a level that came from it can be saved"));
  EXPECT_FALSE(exists("new.tmj"));
}

TEST_F(SessionImportTest, WarnsOfWhatIsDropped) {
  put("room.tmx",
      "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
      "<layer name=\"l\"><data encoding=\"csv\">0</data></layer><objectgroup name=\"things\">"
      "<object x=\"0\" y=\"0\" type=\"door\"/></objectgroup><imagelayer name=\"sky\"><image "
      "source=\"none.png\"/></imagelayer></map>");
  Session session;
  session.apply(action::OpenFile{path("room.tmx")});
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text,
            "Opened room.tmx. Saving keeps what Talus does not show: the picture of the layer \"sky\", file "
            "none.png: cannot be opened: No such file or directory.");
}

TEST_F(SessionImportTest, AMapThatIsNoLevelChangesNothing) {
  put("room.tmx",
      "<map orientation=\"isometric\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\"/>");
  Session session;
  session.apply(action::EditLevel{{"Paint", {CellChange{{0, 0}, 0, 4}}}});
  session.apply(action::OpenFile{path("room.tmx")});
  session.apply(action::AnswerQuestion{action::Answer::discard});
  EXPECT_EQ(session.level().map.at({0, 0}), 4);
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_THAT(session.message()->text, testing::HasSubstr("room.tmx:line 1: error: has the orientation "));
}

// Three layers, a mirrored tile in the second, and one of a large tileset in the third.
constexpr const char* kLayers =
    "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
    "<tileset firstgid=\"1\" name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"16\" columns=\"16\"/>"
    "<tileset firstgid=\"1000\" name=\"u\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"70000\" "
    "columns=\"16\"/>"
    "<layer name=\"back\"><data encoding=\"csv\">3,0</data></layer>"
    "<layer name=\"front\"><data encoding=\"csv\">2147483654,6</data></layer>"
    "<layer name=\"wrong\"><data encoding=\"csv\">1000,0</data></layer></map>";

TEST_F(SessionImportTest, AsksIfTheMapHoldsMoreThanALevelCan) {
  put("two.tmx", kLayers);
  Session session;
  session.apply(action::OpenFile{path("two.tmx")});
  EXPECT_FALSE(session.message());
  ASSERT_TRUE(session.level_import());
  const LevelImport& import = *session.level_import();
  ASSERT_EQ(import.layers.size(), 3u);
  EXPECT_EQ(import.layers[0].name, "back");
  EXPECT_EQ(import.layers[0].cells, 1u);
  EXPECT_EQ(import.choices, ImportChoices{.used_tiles = true}) << "a tileset is too large";
  EXPECT_EQ(import.plan->level.layers.count(), 3);

  session.apply(action::SetLevelImport{{.layer_number = 3}});
  EXPECT_FALSE(session.level_import()->plan);
  session.apply(action::ApplyLevelImport{});
  EXPECT_TRUE(session.level_import()) << "it waits for another choice";
  session.apply(action::SetLevelImport{{.layer_number = 1}});
  ASSERT_TRUE(session.level_import()->plan);
  session.apply(action::ApplyLevelImport{});
  EXPECT_FALSE(session.level_import());
  EXPECT_THAT(session.level().map.cells().tiles(), testing::ElementsAre(2, 0));
  ASSERT_TRUE(session.message());
  EXPECT_THAT(session.message()->text, testing::HasSubstr("does not show: the layer \"front\""));

  session.apply(action::EditLevel{{"Paint", {CellChange{{1, 0}, 0, 2}}}});
  session.apply(action::SaveFile{});
  std::string changed = kLayers;
  changed.replace(changed.find(">3,0<"), 5, ">3,3<");
  EXPECT_EQ(bytes_of("two.tmx"), changed);
}

TEST_F(SessionImportTest, CancellingLeavesTheLevelAsItIs) {
  put("two.tmx", kLayers);
  Session session;
  session.apply(action::EditLevel{{"Paint", {CellChange{{0, 0}, 0, 4}}}});
  session.apply(action::OpenFile{path("two.tmx")});
  EXPECT_FALSE(session.level_import()) << "unsaved changes are asked about first";
  session.apply({action::AnswerQuestion{action::Answer::discard}, action::CancelLevelImport{}});
  EXPECT_FALSE(session.level_import());
  session.apply(action::ApplyLevelImport{});
  EXPECT_EQ(session.level().map.at({0, 0}), 4);
  EXPECT_TRUE(session.modified());
}

TEST_F(SessionImportTest, AsksForALevelOfAProjectOfLdtk) {
  const auto level = [](const std::string& name, const std::string& values) {
    return ldtk_level(ldtk_grid(2, 1, values), name, "\"worldX\":5,\"worldDepth\":1,");
  };
  put("game.ldtk", ldtk_project(level("Cave", "0,1") + "," + level("Top", "1,1")));
  Session session;
  session.apply(action::OpenFile{path("game.ldtk")});
  ASSERT_TRUE(session.level_import());
  ASSERT_EQ(session.level_import()->levels.size(), 2u);
  EXPECT_EQ(session.level_import()->levels[1].name, "Top");
  EXPECT_EQ(session.level_import()->levels[1].x, 5);
  EXPECT_EQ(session.level_import()->levels[1].depth, 1);
  EXPECT_EQ(session.level_import()->levels[1].width, 32);
  EXPECT_EQ(session.level_import()->choices, ImportChoices{.level_number = 1});
  EXPECT_EQ(session.level_import()->plan->level.map.at({0, 0}), 0);
  session.apply({action::SetLevelImport{{.level_number = 2}}, action::ApplyLevelImport{}});
  EXPECT_NE(session.level().map.at({0, 0}), 0);
  EXPECT_EQ(session.path(), path("game.ldtk"));
  session.apply(action::SaveFile{});
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text,
            "Saved what was added to game.ldtk, which LDtk owns, in game.talus.json.");
}

}  // namespace talus::session_import_test
