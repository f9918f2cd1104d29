// The sheet with a tab a tileset, the field that finds tiles, and the marks of used ones.
#include <filesystem>
#include <fstream>

#include "formats/pictures/png_picture.h"
#include "formats/tilesets/displaced_tile.h"
#include "harness.h"
#include "paths.h"

namespace talus::tilesets_ui_test {

class UiTilesets : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    Level level = test_level();
    level.set_tile_layout({20, 600});
    level.tilesets = {{.name = "grass", .first = 0, .count = 200, .columns = 10},
                      {.name = "rock", .first = 200, .count = 400, .columns = 20}};
    level.sheet(SheetId::tiles).flags[575] = 1;
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    start(path("level.talus.json"));
  }
  int chosen_tile() { return session().choices().area.tile_at(level(), 0, 0); }
  // The middle of a place of the shown tileset with so many columns.
  ImVec2 in_tab(Cell place, int columns) {
    const Widget* sheet = find("sheet/tiles");
    const float cell = (sheet->max.x - sheet->min.x) / static_cast<float>(columns);
    return {sheet->min.x + cell * (static_cast<float>(place.x) + 0.5f),
            sheet->min.y + cell * (static_cast<float>(place.y) + 0.5f)};
  }
};

TEST_F(UiTilesets, ATabShowsOneAloneAndItsTilesArePainted) {
  click("sheet/tileset0");
  frames(2);
  click(in_tab({9, 1}, 10));
  EXPECT_EQ(chosen_tile(), 29);
  click(on_map({7, 3}));
  EXPECT_EQ(tile_at({7, 3}), 29);
  click("sheet/tileset1");
  frames(2);
  drag(in_tab({0, 0}, 20), in_tab({1, 1}, 20));
  EXPECT_EQ(session().choices().stamp.tiles, (std::vector<MapCell>{200, 201, 220, 221}));
  click("sheet/tileset-1");
  frames(2);
  click(on_sheet(15));
  EXPECT_EQ(chosen_tile(), 15);
}

// Its first tile is drawn, so tile 0, the empty one, is in its place.
TEST_F(UiTilesets, TheFirstTileOfAMapOfTiledIsSeenInItsPlace) {
  std::filesystem::copy(source_path("assets/platformer"), path("platformer"));
  start(path("platformer/meadow.tmx"));
  const TileNumber first = displaced_tile(level());
  ASSERT_NE(first, 0);
  EXPECT_EQ(session().choices().stamp.tiles, std::vector<MapCell>{first}) << "one does not paint emptiness";
  const float top = find("sheet/tiles")->min.y;
  click(in_tab({1, 0}, 12));
  click(in_tab({0, 0}, 12));
  frames(3);
  EXPECT_EQ(session().choices().stamp.tiles, std::vector<MapCell>{first});
  EXPECT_EQ(chosen_tile(), first) << "flags and pixels are those of the tile that is seen there";
  EXPECT_EQ(find("sheet/tiles")->min.y, top) << "the sheet does not go to where it really is";
  drag(in_tab({0, 0}, 12), in_tab({1, 1}, 12));
  EXPECT_EQ(session().choices().stamp.tiles, (std::vector<MapCell>{first, 1, 12, 13}));
}

TEST_F(UiTilesets, ManyAreTabsThatScroll) {
  Level level = session().level();
  level.tilesets.clear();
  for (int set = 0; set < 30; ++set)
    level.tilesets.push_back(
        {.name = "tileset number " + std::to_string(set), .first = 20 * set, .count = 20, .columns = 20});
  ASSERT_TRUE(save_level(level, *find_format("native"), path("many.talus.json")));
  start(path("many.talus.json"), 900, 600);
  EXPECT_NE(find("sheet/tileset0"), nullptr);
  EXPECT_EQ(find("sheet/tileset"), nullptr) << "no list";
  app().ui().view.sprites.tileset = 29;
  frames(30);
  const Widget *tab = find("sheet/tileset29"), *room = find("sheet/canvas");
  ASSERT_NE(tab, nullptr);
  EXPECT_GE(tab->min.x, room->min.x - 1);
  EXPECT_LE(tab->centre().x, room->max.x);
  EXPECT_EQ(app().ui().view.sprites.tileset, 29);
}

TEST_F(UiTilesets, FoundTilesAreReachedWithEnter) {
  click("sheet/find");
  type("solid rock");
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(chosen_tile(), 575);
  const Widget* sheet = find("sheet/tiles");
  ASSERT_NE(sheet, nullptr);
  const ImVec2 at = on_sheet(575);
  EXPECT_GT(at.y, 0) << "it is scrolled to";
  EXPECT_LT(at.y, ImGui::GetIO().DisplaySize.y);
}

TEST_F(UiTilesets, UsedTilesAreMarked) {
  EXPECT_FALSE(app().ui().view.sprites.marks_used);
  click("sheet/used");
  EXPECT_TRUE(app().ui().view.sprites.marks_used);
  click("sheet/used");
  EXPECT_FALSE(app().ui().view.sprites.marks_used);
}

TEST_F(UiTilesets, OneIsRenamedAndRemoved) {
  click(on_map({7, 3}));
  click("sheet/tileset1");
  click("sheet/tileset_menu");
  frames(2);
  click("sheet/tileset_name");
  key(ctrl('a'));
  type("stone");
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(level().tilesets[1].name, "stone");
  click("sheet/remove_tileset");
  frames(3);
  ASSERT_EQ(level().tilesets.size(), 1u);
  EXPECT_EQ(level().tile_count(), 200);
  session().apply({action::Undo{}, action::Undo{}});
  EXPECT_EQ(level().tilesets[1].name, "rock");
  EXPECT_EQ(level().tile_count(), 600);
}

TEST_F(UiTilesets, ANewLevelIsMadeOfTiles) {
  const auto set = [&](const char* field, const char* text) {
    click(field);
    key(ctrl('a'));
    type(text);
    key(kKeyTab);
    frames(2);
  };
  const std::vector<std::uint8_t> grey(4 * 70 * 36, 200);
  const std::string png = path("grey.png");
  std::ofstream(png, std::ios::binary) << encode_png(70, 36, 4, grey.data());
  session().apply(action::OpenTiles{png});
  frames(5);
  ASSERT_NE(find("tiles/picture"), nullptr);
  set("tiles/tile_width", "0");
  EXPECT_FALSE(find("tiles/apply")->enabled);
  set("tiles/tile_width", "16");
  set("tiles/tile_height", "16");
  set("tiles/spacing", "2");
  EXPECT_TRUE(find("tiles/apply")->enabled);
  click("tiles/apply");
  frames(3);
  EXPECT_FALSE(session().tile_import());
  ASSERT_EQ(level().tilesets.size(), 1u);
  EXPECT_EQ(level().tilesets[0].columns, 4);
  EXPECT_EQ(level().tilesets[0].name, "grey");
  EXPECT_EQ(level().map.tile_size(), (TileSize{16, 16}));
  session().apply(action::OpenFile{png});
  frames(5);
  ASSERT_TRUE(session().tile_import()) << "it cannot be drawn on a sheet in true colour";
  EXPECT_EQ(find("tiles/draw"), nullptr);
  click("tiles/cancel");
  session().apply(action::OpenTiles{png, true});
  frames(5);
  click("tiles/apply");
  frames(3);
  EXPECT_EQ(level().tilesets.size(), 2u);
  session().apply(action::Undo{});
  EXPECT_EQ(level().tilesets.size(), 1u);
}

}  // namespace talus::tilesets_ui_test
