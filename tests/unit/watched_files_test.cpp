// Files of other kinds than maps of Tiled that other programs change while a level is open: pictures of
// tilesets, projects of LDtk, carts.
#include <gmock/gmock.h>

#include <filesystem>

#include "folder_test.h"
#include "ldtk_text.h"
#include "png_bytes.h"
#include "session/session.h"

namespace talus::watched_files_test {

namespace fs = std::filesystem;
namespace act = action;
using testing::HasSubstr;

class WatchedFiles : public FolderTest {
 protected:
  void open(const std::string& name) {
    session_.apply(act::OpenFile{path(name)});
    if (session_.level_import()) session_.apply(act::ApplyLevelImport{});
    session_.apply(act::DismissMessage{});
  }
  void check() { session_.apply(act::CheckFile{}); }
  const Level& level() const { return session_.level(); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }
  void paint(Cell cell, TileNumber tile) {
    session_.apply(act::EditLevel{Edit{"Paint", {CellChange{cell, level().map.tile_at(cell), tile}}}});
  }
  // 32x16 px in one colour: two tiles of 16x16 px.
  static std::string picture(char red) {
    std::string row;
    for (int x = 0; x < 32; ++x) row += {red, 0, 0};
    return png_of(32, 2, std::vector<std::string>(16, row));
  }
  // The red of the corner of a tile.
  int red_of(int tile) const {
    const Sheet& sheet = level().sheet(SheetId::tiles);
    if (sheet.picture == nullptr) return level().palette[sheet.images[static_cast<std::size_t>(tile)][0]].r;
    const Cell place = sheet.layout().place_of(tile);
    return *sheet.picture->at(16 * place.x, 16 * place.y);
  }

  Session session_;
};

TEST_F(WatchedFiles, APictureOfATilesetOfTiledIsDrawnAnew) {
  put("t.png", picture(10));
  put("map.tmx", R"(<map orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="2" columns="2">
  <image source="t.png" width="32" height="16"/></tileset>
 <layer name="l" width="2" height="1"><data encoding="csv">1,2</data></layer>
</map>)");
  open("map.tmx");
  const int tile = level().map.tile_at({1, 0});
  ASSERT_EQ(red_of(tile), 10) << message();
  put("t.png", picture(99));
  check();
  EXPECT_EQ(red_of(tile), 99) << message();
  EXPECT_FALSE(session_.modified());
  fs::remove(path("t.png"));
  check();
  EXPECT_EQ(red_of(tile), 99) << "what is gone stays on screen";
  EXPECT_EQ(message(), "t.png was removed or renamed by another program.");
  put("t.png", picture(50));
  check();
  EXPECT_EQ(red_of(tile), 50);
}

TEST_F(WatchedFiles, APictureThatALevelLinksToIsDrawnAnew) {
  put("t.png", picture(10));
  session_.apply(act::OpenTiles{path("t.png")});
  ASSERT_TRUE(session_.tile_import());
  session_.apply(act::ApplyTiles{.cut = {.tile = {16, 16}}, .width = 4, .height = 4, .is_linked = true});
  session_.apply(act::SaveFileAs{path("level.talus.json")});
  ASSERT_EQ(session_.path(), path("level.talus.json")) << message();
  const int tile = level().tilesets[0].first;
  ASSERT_EQ(red_of(tile), 10);
  put("t.png", picture(99));
  check();
  EXPECT_EQ(red_of(tile), 99) << message();
  paint({0, 0}, 1);
  put("t.png", picture(50));
  check();
  EXPECT_EQ(red_of(tile), 50) << message();
  EXPECT_EQ(level().map.at({0, 0}), 1) << "what was changed here is kept";
  EXPECT_TRUE(session_.modified());
}

TEST_F(WatchedFiles, APictureWhoseNameIsNotUtf8IsTaken) {
  put("t\xff.png", picture(10));
  session_.apply(act::OpenTiles{path("t\xff.png")});
  ASSERT_TRUE(session_.tile_import());
  session_.apply(act::ApplyTiles{.cut = {.tile = {16, 16}}, .width = 4, .height = 4});
  EXPECT_EQ(level().tilesets[0].name, "t\\xff");
  session_.apply(act::SaveFileAs{path("level.talus.json")});
  EXPECT_EQ(session_.path(), path("level.talus.json")) << message();
  session_.apply(act::OpenTiles{path("t\xff.png")});
  session_.apply(act::ApplyTiles{.cut = {.tile = {16, 16}}, .width = 4, .height = 4, .is_linked = true});
  session_.apply(act::SaveFileAs{path("linked.talus.json")});
  EXPECT_EQ(message(), path("linked.talus.json") + ":key tilesets[0].image: error: is not valid UTF-8");
}

class WatchedProjects : public WatchedFiles {
 protected:
  void put_project(const std::string& cave) const {
    std::string text = ldtk_project(ldtk_level(ldtk_grid(4, 2, cave), "Cave", R"("iid":"c",)"),
                                    R"({"value":1,"identifier":"wall"},{"value":2,"identifier":"ice"})");
    text.insert(1, R"("iid":"p",)");
    put("game.ldtk", text);
  }
};

TEST_F(WatchedProjects, ALevelIsReadAgain) {
  put_project("1,0,0,0,0,0,0,0");
  open("game.ldtk");
  const TileNumber wall = level().map.tile_at({0, 0});
  put_project("1,1,0,0,0,0,0,2");
  check();
  EXPECT_EQ(level().map.at({1, 0}), wall) << message();
  EXPECT_NE(level().map.tile_at({3, 1}), level().map.tile_at({2, 1}));
  EXPECT_FALSE(session_.modified());
}

TEST_F(WatchedProjects, ALevelInAFileOfItsOwnIsReadAgain) {
  const std::string head =
      R"({"identifier":"Cave","pxWid":16,"pxHei":8,"layerInstances":null,"externalRelPath":"Cave.ldtkl"})";
  put("game.ldtk", ldtk_project(head, R"({"value":1,"identifier":"wall"})"));
  put("Cave.ldtkl", ldtk_level(ldtk_grid(2, 1, "0,1")));
  open("game.ldtk");
  const TileNumber wall = level().map.tile_at({1, 0});
  ASSERT_NE(level().map.at({0, 0}), wall);
  put("Cave.ldtkl", ldtk_level(ldtk_grid(2, 1, "1,1")));
  check();
  EXPECT_EQ(level().map.at({0, 0}), wall) << message();
}

TEST_F(WatchedProjects, WhatWasPaintedHereStaysAndMeetsWhatLdtkChanged) {
  put_project("1,2,0,0,0,0,0,0");
  open("game.ldtk");
  const TileNumber wall = level().map.tile_at({0, 0}), ice = level().map.tile_at({1, 0});
  paint({2, 0}, wall);
  session_.apply(act::SaveFile{});
  ASSERT_FALSE(session_.modified()) << message();
  put_project("1,2,0,1,0,0,0,0");
  check();
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(level().map.at({2, 0}), wall);
  EXPECT_EQ(level().map.at({3, 0}), wall);
  EXPECT_FALSE(session_.modified());
  put_project("1,2,2,1,0,0,0,0");  // the cell that was painted here, and saved beside the project
  check();
  ASSERT_TRUE(session_.question()) << message();
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
  EXPECT_THAT(session_.question()->text, HasSubstr("Both changed 1 cell,"));
  session_.apply(act::AnswerQuestion{act::Answer::keep});
  EXPECT_EQ(level().map.at({2, 0}), wall);
  session_.apply(act::SaveFile{});
  Session again;
  again.apply(act::OpenFile{path("game.talus.json")});
  EXPECT_EQ(again.level().map.at({2, 0}), wall) << "saved beside the newer project";
  session_.apply(act::Undo{});
  session_.apply(act::Redo{});
  EXPECT_NE(ice, wall);
}

TEST_F(WatchedProjects, SavingAfterUndoIsBesideTheNewerProject) {
  put_project("1,2,0,0,0,0,0,0");
  open("game.ldtk");
  const TileNumber wall = level().map.tile_at({0, 0});
  put_project("1,2,1,0,0,0,0,0");
  check();
  ASSERT_EQ(level().map.at({2, 0}), wall);
  session_.apply(act::Undo{});
  const TileNumber empty = level().map.tile_at({2, 0});
  session_.apply(act::SaveFile{});
  ASSERT_FALSE(session_.modified()) << message();
  Session again;
  again.apply(act::OpenFile{path("game.talus.json")});
  EXPECT_EQ(again.level().map.at({2, 0}), empty) << "the level was saved as it was shown";
}

// TIC-80 writes the cart while it is open here.
TEST_F(WatchedFiles, SavingAfterUndoKeepsTheNewerCodeOfACart) {
  session_.apply(act::SaveFileAs{path("game.tic")});
  paint({0, 0}, 3);
  session_.apply(act::SaveFile{});
  const std::string code = "print('new')";
  const std::string newer =
      bytes_of("game.tic") + '\x05' + static_cast<char>(code.size()) + '\0' + '\0' + code;
  put("game.tic", newer);
  check();
  ASSERT_THAT(message(), HasSubstr("again"));
  session_.apply({act::Undo{}, act::Undo{}});
  ASSERT_EQ(level().map.at({0, 0}), 0);
  session_.apply(act::SaveFile{});
  EXPECT_THAT(bytes_of("game.tic"), HasSubstr(code)) << message();
  EXPECT_EQ(load_level(path("game.tic"))->level.map.at({0, 0}), 0);
  session_.apply({act::Redo{}, act::Redo{}});
  EXPECT_EQ(level().map.at({0, 0}), 3);
}

// The body that fell a while falls on, onto the ground that Tiled has put under it.
TEST_F(WatchedFiles, ARunningGameGoesOnWithTheNewGround) {
  const auto map = [](const std::string& lowest) {
    std::string rows;
    for (int y = 0; y < 9; ++y) rows += "0,0,0,";
    return R"(<map orientation="orthogonal" width="3" height="10" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="2" columns="2">
  <image source="t.png" width="32" height="16"/><tile id="0"><properties>
  <property name="solid" type="bool" value="true"/></properties></tile></tileset>
 <layer name="l" width="3" height="10"><data encoding="csv">)" +
           rows + lowest + R"(</data></layer>
 <objectgroup><object id="1" type="player" x="16" y="16" width="8" height="8"/></objectgroup>
</map>)";
  };
  put("t.png", picture(10));
  put("map.tmx", map("0,0,0"));
  open("map.tmx");
  ASSERT_EQ(session_.state().bodies.size(), 1u) << message();
  for (int i = 0; i < 20; ++i) session_.apply(act::StepFrame{});
  const auto frame = session_.state().frame;
  const double height = session_.state().bodies[0].box.y;
  ASSERT_GT(height, 16.0);
  put("map.tmx", map("1,1,1"));
  check();
  EXPECT_EQ(session_.state().frame, frame) << message();
  EXPECT_EQ(session_.state().bodies[0].box.y, height);
  for (int i = 0; i < 600; ++i) session_.apply(act::StepFrame{});
  EXPECT_EQ(session_.state().frame, frame + 600);
  EXPECT_NEAR(session_.state().bodies[0].box.y, 9 * 16 - 8, 0.01) << "it lies on the new ground";
}

}  // namespace talus::watched_files_test
