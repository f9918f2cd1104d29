// Maps whose files other programs change while they are open: the map, its tilesets, a project's level.
#include <gtest/gtest.h>

#include <filesystem>

#include "edit/shape_tools.h"
#include "folder_test.h"
#include "session/session.h"

namespace talus::linked_change_test {

namespace fs = std::filesystem;
namespace act = action;

class LinkedChanges : public FolderTest {
 protected:
  void SetUp() override {
    put("t.tsx", tileset(""));
    put("map.tmx", map("1,0,0,0,0,0,0,0,0", ""));
    session_.apply(act::OpenFile{path("map.tmx")});
    ASSERT_EQ(session_.path(), path("map.tmx"));
    session_.apply(act::DismissMessage{});
  }

  // A set of four tiles; more: in tile 1.
  static std::string tileset(const std::string& more) {
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.8" name="t" tilewidth="16" tileheight="16" tilecount="4" columns="4">
 <image source="t.png" width="64" height="16"/>
 <tile id="1">)" +
           more + "</tile>\n</tileset>\n";
  }
  static std::string solid(int top) {
    return R"(<objectgroup><object id="1" x="0" y=")" + std::to_string(top) + R"(" width="16" height=")" +
           std::to_string(16 - top) + R"("/></objectgroup>)";
  }
  // A map of 3x3 cells.
  static std::string map(const std::string& cells, const std::string& properties) {
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<map version="1.8" orientation="orthogonal" width="3" height="3" tilewidth="16" tileheight="16">
 )" + properties +
           R"(<tileset firstgid="1" source="t.tsx"/>
 <layer id="1" name="main" width="3" height="3"><data encoding="csv">)" +
           cells + "</data></layer>\n</map>\n";
  }
  void check() { session_.apply(act::CheckFile{}); }
  auto cell(int x, int y) const { return session_.level().map.tile_at({x, y}); }
  void paint(int x, int y, int tile) {
    session_.apply(
        act::EditLevel{Edit{"Paint", {CellChange{{x, y}, cell(x, y), static_cast<TileNumber>(tile)}}}});
  }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }

  Session session_;
};

TEST_F(LinkedChanges, UnchangedFilesAreLeftAlone) {
  check();
  EXPECT_EQ(message(), "");
  EXPECT_TRUE(session_.history().edits().empty());
}

TEST_F(LinkedChanges, AMapIsReadAgainWithoutAQuestion) {
  const auto first = cell(0, 0);
  put("map.tmx", map("1,1,0,0,0,0,0,0,0", ""));
  check();
  EXPECT_EQ(cell(1, 0), first);
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(session_.history().edits().size(), 1u);
  session_.apply(act::Undo{});
  EXPECT_NE(cell(1, 0), first);
}

TEST_F(LinkedChanges, ATilesetIsWatchedToo) {
  const auto shapes = session_.level().tile_shapes;
  put("t.tsx", tileset(solid(8)));
  check();
  EXPECT_NE(session_.level().tile_shapes, shapes) << message();
  EXPECT_FALSE(session_.modified());
  check();
  EXPECT_EQ(session_.history().edits().size(), 1u) << "each change is read once";
}

TEST_F(LinkedChanges, AHalfWrittenTilesetIsTriedAgain) {
  const auto shapes = session_.level().tile_shapes;
  put("t.tsx", tileset(solid(8)).substr(0, 150));
  check();
  EXPECT_EQ(message(), "");
  put("t.tsx", tileset(solid(8)));
  check();
  EXPECT_NE(session_.level().tile_shapes, shapes) << message();
}

TEST_F(LinkedChanges, ATilesetThatIsGoneLeavesTheLevelAndComesBack) {
  const Level before = session_.level();
  fs::remove(path("t.tsx"));
  check();
  EXPECT_EQ(message(), "t.tsx was removed or renamed by another program.");
  EXPECT_EQ(session_.level(), before);
  EXPECT_FALSE(session_.modified());
  put("t.tsx", tileset(solid(8)));
  check();
  EXPECT_NE(session_.level().tile_shapes, before.tile_shapes);
}

TEST_F(LinkedChanges, APlayedGameGoesOnWithTheNewGround) {
  for (int i = 0; i < 5; ++i) session_.apply(act::StepFrame{});
  const auto frame = session_.state().frame;
  session_.apply(act::SelectCells{CellRect{0, 0, 2, 2}});
  put("t.tsx", tileset(solid(8)));
  check();
  EXPECT_EQ(session_.state().frame, frame);
  session_.apply(act::StepFrame{});
  EXPECT_EQ(session_.state().frame, frame + 1);
  EXPECT_TRUE(session_.choices().selection) << "what was chosen stays so";
}

// Talus does not show properties of the map, and writes them back nevertheless.
TEST_F(LinkedChanges, WhatOnlyTheNewerFileHoldsIsSaved) {
  const std::string properties = R"(<properties><property name="music" value="a"/></properties>)";
  put("map.tmx", map("1,0,0,0,0,0,0,0,0", properties));
  check();
  paint(2, 2, cell(0, 0));
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("map.tmx"), map("1,0,0,0,0,0,0,0,1", properties)) << message();
}

TEST_F(LinkedChanges, SavingAfterUndoKeepsWhatOnlyTheNewerFileHolds) {
  const std::string properties = R"(<properties><property name="music" value="a"/></properties>)";
  put("map.tmx", map("1,1,0,0,0,0,0,0,0", properties));
  check();
  session_.apply(act::Undo{});
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("map.tmx"), map("1,0,0,0,0,0,0,0,0", properties)) << message();
}

TEST_F(LinkedChanges, SavingAfterUndoLeavesFilesThatHaveOtherTiles) {
  const std::string wider = R"(<tileset firstgid="5" name="more" tilewidth="16" tileheight="16" )"
                            R"(tilecount="4" columns="4"><image source="m.png" width="64" height="16"/>)"
                            R"(</tileset>)";
  std::string newer = map("1,0,0,0,0,0,0,0,5", "");
  newer.insert(newer.find(" <layer"), wider);
  put("map.tmx", newer);
  for (int i = 0; i < 4; ++i) check();  // m.png might still be written
  ASSERT_EQ(session_.history().edits().size(), 1u) << message();
  session_.apply(act::Undo{});
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("map.tmx"), newer);
  EXPECT_NE(message().find("Redo"), std::string::npos) << message();
  session_.apply(act::Redo{});
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("map.tmx"), newer) << message();
}

TEST_F(LinkedChanges, BothSidesAreMergedAndSavedIntoTheNewerFile) {
  const auto tile = cell(0, 0);
  paint(2, 2, tile);
  put("map.tmx", map("1,1,0,0,0,0,0,0,0", "<properties/>"));
  check();
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(cell(1, 0), tile);
  EXPECT_EQ(cell(2, 2), tile);
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("map.tmx"), map("1,1,0,0,0,0,0,0,1", "<properties/>")) << message();
  check();
  EXPECT_FALSE(session_.modified());
}

TEST_F(LinkedChanges, SavingAsksIfBothChangedTheSame) {
  paint(1, 1, 3);
  put("map.tmx", map("1,0,0,0,3,0,0,0,0", ""));
  session_.apply(act::SaveFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
  EXPECT_EQ(bytes_of("map.tmx"), map("1,0,0,0,3,0,0,0,0", ""));
  session_.apply(act::AnswerQuestion{act::Answer::reload});
  EXPECT_FALSE(session_.modified()) << "theirs is what the file has";
  session_.apply(act::Undo{});
  EXPECT_EQ(cell(1, 1), 3) << "nothing is lost";
}

TEST_F(LinkedChanges, AShapeDrawnHereAndACellPaintedThereAreBothKept) {
  std::vector<TileShape> shapes = session_.level().tile_shapes;
  session_.apply(act::EditLevel{
      Edit{"Shape", {TileShapeChange{3, shapes[3], TileShape{.kind = TileShape::Kind::solid}}}}});
  put("map.tmx", map("1,1,0,0,0,0,0,0,0", ""));
  check();
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(session_.level().tile_shapes[3].kind, TileShape::Kind::solid);
  EXPECT_EQ(cell(1, 0), cell(0, 0));
  EXPECT_TRUE(session_.modified());
}

}  // namespace talus::linked_change_test
