// The sheet's own view: how it opens, zooms and moves.
#include "harness.h"

namespace talus::sheet_view_test {

class UiSheetView : public UiTest {
 protected:
  // A level whose sheet has so many tiles.
  std::string save_sheet(const std::string& name, int columns, int tiles, TileSize size = {8, 8}) {
    Level level = test_level();
    level.map = TileMap(30, 17, size);
    level.set_tile_layout({columns, tiles});
    const std::string file = path(name);
    EXPECT_TRUE(save_level(level, *find_format("native"), file));
    return file;
  }
  float tile_width() {
    const Widget* sheet = find("sheet/tiles");
    return (sheet->max.x - sheet->min.x) / static_cast<float>(level().sheet(SheetId::tiles).layout().columns);
  }
  int pointed_tile(ImVec2 at) {
    move(at);
    return app().ui().view.canvas.hover.tile.value_or(-1);
  }
};

TEST_F(UiSheetView, OpensWithTilesThatCanBeSeen) {
  for (const TileSize size : {TileSize{8, 8}, TileSize{16, 16}, TileSize{100, 100}})
    for (const auto& [columns, tiles] : {std::pair{16, 256}, {32, 1024}, {4, 16}, {2, 400}, {200, 400}}) {
      for (const int width : {900, 1280}) {
        start(save_sheet("level.talus.json", columns, tiles, size), width, width == 900 ? 600 : 720);
        EXPECT_GE(tile_width(), 24) << columns << " columns, " << size.width << " px, in " << width;
        const Widget *sheet = find("sheet/tiles"), *room = find("sheet/canvas");
        EXPECT_GE(sheet->min.x, room->min.x) << "its corner is in sight";
        EXPECT_GE(sheet->min.y, room->min.y);
      }
    }
}

TEST_F(UiSheetView, ColumnsThatFitAreNotCut) {
  for (const int columns : {7, 8, 9, 10}) {
    start(save_sheet("level.talus.json", columns, 10 * columns, {16, 16}));
    const Widget *sheet = find("sheet/tiles"), *room = find("sheet/canvas");
    EXPECT_LE(sheet->max.x, room->max.x + 0.5f) << columns;
    EXPECT_GE(tile_width(), 24) << columns;
  }
}

TEST_F(UiSheetView, ASheetWithLessThanItsRoomBeginsAtTheTop) {
  start(save_sheet("level.talus.json", 4, 16), 1920, 1080);
  const Widget *sheet = find("sheet/tiles"), *room = find("sheet/canvas");
  EXPECT_LT(sheet->max.y, room->max.y) << "the sheet is lower than its room";
  EXPECT_EQ(sheet->min.x, room->min.x);
  EXPECT_EQ(sheet->min.y, room->min.y);
}

TEST_F(UiSheetView, ItHasTheWholeRoomOfItsPanel) {
  start(save_sheet("level.talus.json", 16, 256));
  const Widget *room = find("sheet/canvas"), *header = find("sheet/show_tiles");
  EXPECT_EQ(room->min.x, header->min.x);
  EXPECT_GE(room->max.x - room->min.x, 250);
  EXPECT_GE(room->max.y, find("layout/sheet")->min.y - 8);
}

TEST_F(UiSheetView, TheWheelZoomsAtTheMouse) {
  start(save_sheet("level.talus.json", 20, 2000));
  const ImVec2 at = on_sheet(63);
  const float before = tile_width();
  move(at);
  wheel(1);
  frames(2);
  EXPECT_GT(tile_width(), before);
  EXPECT_EQ(pointed_tile(at), 63);
  wheel(-3);
  frames(2);
  EXPECT_LT(tile_width(), before);
  EXPECT_EQ(pointed_tile(at), 63);
}

TEST_F(UiSheetView, TheMiddleButtonAndSpaceMoveIt) {
  start(save_sheet("level.talus.json", 20, 2000));
  const CellRect chosen = session().choices().area.tiles;
  const ImVec2 from = on_sheet(65), to{from.x - 40, from.y - 56};
  drag(from, to, kMiddle);
  EXPECT_EQ(pointed_tile(to), 65);
  hold(' ');
  drag(to, from);
  let_go(' ');
  EXPECT_EQ(pointed_tile(from), 65);
  EXPECT_EQ(session().choices().area.tiles, chosen) << "nothing is selected";
}

TEST_F(UiSheetView, OnlyAChosenZoomIsKeptForAnotherLevel) {
  const std::string small = save_sheet("small.talus.json", 2, 4);
  start(save_sheet("level.talus.json", 20, 2000));
  const float opened = tile_width();
  drop(small);
  frames(3);
  EXPECT_GT(tile_width(), opened) << "as it fits";
  drop(path("level.talus.json"));
  frames(3);
  EXPECT_EQ(tile_width(), opened);
  click("sheet/zoom_out");
  frames(2);
  const float chosen = tile_width();
  EXPECT_LT(chosen, opened);
  drop(small);
  frames(3);
  EXPECT_EQ(tile_width(), chosen);
}

TEST_F(UiSheetView, ATileChosenElsewhereComesIntoSight) {
  start(save_sheet("level.talus.json", 20, 2000));
  session().apply(action::SelectTiles{{SheetId::tiles, {19, 99, 1, 1}}});
  frames(2);
  const Widget *sheet = find("sheet/tiles"), *room = find("sheet/canvas");
  EXPECT_LE(sheet->max.x, room->max.x + 1);
  EXPECT_LE(sheet->max.y, room->max.y + 1);
}

TEST_F(UiSheetView, AClickBesideTheTilesSelectsNothing) {
  start(save_sheet("level.talus.json", 2, 2));
  click(on_sheet(1));
  const CellRect chosen = session().choices().area.tiles;
  const Widget* room = find("sheet/canvas");
  click(ImVec2{(room->min.x + room->max.x) / 2, room->max.y - 2});
  EXPECT_EQ(session().choices().area.tiles, chosen);
}

class UiSheetFold : public UiSheetView {
 protected:
  void start_in_true_colour(int width = 1280, int height = 720) {
    Level level = test_level();
    level.set_tile_layout({8, 64});
    SheetPicture picture{64, 64, std::vector<std::uint8_t>(4 * 64 * 64, 200)};
    level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
    ASSERT_TRUE(save_level(level, *find_format("native"), path("rgba.talus.json")));
    start(path("rgba.talus.json"), width, height);
  }
  float sheet_height() { return find("sheet/canvas")->max.y - find("sheet/canvas")->min.y; }
};

TEST_F(UiSheetFold, PixelsWaitUntilTheyAreAskedFor) {
  start_in_true_colour();
  EXPECT_EQ(find("pixels/canvas"), nullptr);
  EXPECT_EQ(find("palette/left"), nullptr);
  EXPECT_NE(find("flags/lamp0"), nullptr);
  EXPECT_GT(sheet_height(), 400);
  click("sheet/show_sprites");
  frames(2);
  EXPECT_NE(find("pixels/canvas"), nullptr) << "sprites with a palette are there to be drawn";
  click("sheet/show_tiles");
  frames(2);
  click("pixels/show");
  frames(2);
  EXPECT_NE(find("pixels/canvas"), nullptr);
  EXPECT_LT(sheet_height(), 400);
  stop();
  start(path("rgba.talus.json"));
  EXPECT_NE(find("pixels/canvas"), nullptr) << "it is remembered";
  click("pixels/show");
  frames(2);
  EXPECT_EQ(find("pixels/canvas"), nullptr);
}

TEST_F(UiSheetFold, APixelToolAsksForThem) {
  start_in_true_colour(900, 600);
  ASSERT_EQ(find("pixels/canvas"), nullptr);
  key(kKeyF2);
  key('4');
  frames(2);
  EXPECT_NE(find("pixels/canvas"), nullptr);
}

TEST_F(UiSheetFold, ASheetWithAPaletteHasThem) {
  start();
  EXPECT_NE(find("pixels/canvas"), nullptr);
  EXPECT_EQ(find("pixels/show"), nullptr);
}

}  // namespace talus::sheet_view_test
