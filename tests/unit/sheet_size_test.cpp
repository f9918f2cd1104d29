// Sheets with other columns and more tiles than those of a cart.
#include <gmock/gmock.h>

#include <talus/level/limits.h>
#include "edit/sprite_area.h"
#include "edit/stamp.h"
#include "exported_level.h"
#include "level/edit.h"
#include "native_text.h"
#include "session/editing/map_clipboard.h"

namespace talus::sheet_size_test {

using testing::HasSubstr;

// A level of 20 columns and 1,000 tiles with one of each thing that names tiles.
Level large() {
  Level level;
  level.map = TileMap(30, 20, {16, 16});
  level.set_tile_layout({20, 1000});
  level.map.set({3, 4}, 999);
  level.map.set({4, 4}, 7);
  level.sheet(SheetId::tiles).images[999].fill(5);
  level.sheet(SheetId::tiles).flags[998] = 1;
  level.tile_shapes[999] = {.kind = TileShape::Kind::slope, .heights = {0, 16}};
  level.brushes.push_back({"bush", 2, 1, {999, 0}, false, ""});
  level.auto_tiles.of(GroundPart::inside) = 998;
  return level;
}

TEST(SheetSize, LayoutFindsPlacesAndImages) {
  const SheetLayout sheet{20, 1000 - 3};
  EXPECT_EQ(sheet.rows(), 50);
  EXPECT_EQ(sheet.place_of(996), (Cell{16, 49}));
  EXPECT_EQ(sheet.tile_at({16, 49}), 996);
  EXPECT_TRUE(sheet.contains({16, 49}));
  EXPECT_FALSE(sheet.contains({17, 49})) << "the last row is shorter";
  EXPECT_FALSE(sheet.contains({20, 0}));
  EXPECT_FALSE(sheet.contains({-1, 1}));
  EXPECT_EQ(sheet.nearest({99, 99}), (Cell{19, 48})) << "above the end of the last row";
  EXPECT_EQ(sheet.nearest({-5, 99}), (Cell{0, 49}));
  EXPECT_EQ((SheetLayout{20, 3}.nearest({9, 0})), (Cell{2, 0}));
}

TEST(SheetSize, IsKeptByTheNativeFormat) {
  const std::string text = native_of_level(large());
  EXPECT_THAT(text, HasSubstr("\"talus\": 3"));
  EXPECT_THAT(text, HasSubstr("............03e70007"));
  EXPECT_TRUE(level_of_native(text) == large());
}

TEST(SheetSize, OlderLevelsKeepTheirVersions) {
  Level level;
  EXPECT_THAT(native_of_level(level), HasSubstr("\"talus\": 1"));
  level.map = TileMap(2, 2, {16, 16});
  EXPECT_THAT(native_of_level(level), HasSubstr("\"talus\": 2"));
  level.set_tile_layout({8, 256});
  EXPECT_THAT(native_of_level(level), HasSubstr("\"talus\": 3"));
}

TEST(SheetSize, TilesThatTheSheetLacksAreRefused) {
  const std::string size = R"("sheet_size": [20, 300], )";
  expect_native_error(native_with(size + R"("map": {"width": 1, "height": 1, "rows": ["012c"]})"),
                      "map row 0", "has a cell, number 0, with tile 300, but there are only 300 tiles");
  expect_native_error(native_with(size + R"("map": {"width": 1, "height": 1, "rows": ["01"]})"), "map row 0",
                      "must have four characters for each cell");
  expect_native_error(native_with(size + R"("brushes": [{"name": "b", "rows": ["012c"]}])"),
                      "key brushes[0].rows", "has tile 300, but there are only 300 tiles");
  expect_native_error(native_with(size + R"("auto_tiles": {"inside": 300})"), "key auto_tiles.inside",
                      "must be a tile number from 1 to 299");
  expect_native_error(native_with(size + R"("tiles": {"300": {"flags": [1]}})"), "key tiles.300",
                      "must be a tile number from 0 to 299");
  expect_native_error(
      native_with(R"("sheet_size": [16, 2], "map": {"width": 1, "height": 1, "rows": ["02"]})"), "map row 0",
      "has a cell, number 0, with tile 2, but there are only 2 tiles");
}

TEST(SheetSize, ItselfIsLimited) {
  const std::string wanted =
      "must be [columns, tiles]: 1 to 2048 columns, 1 to 65536 tiles, and at most 2048 rows";
  for (const char* size :
       {"[16]", "16", "[0, 256]", "[2049, 256]", "[16, 0]", "[64, 65537]", "[1, 2049]", "[1.5, 3]"})
    expect_native_error(native_with(std::string("\"sheet_size\": ") + size), "key sheet_size", wanted);
  EXPECT_EQ(level_of_native(native_with("\"sheet_size\": [32, 65536]")).tile_count(), 65536);
}

TEST(SheetSize, ShapesAreCountedWithTheirParts) {
  Level level;
  level.set_tile_layout({16, 4096});
  TileShape polygon{.kind = TileShape::Kind::polygon};
  polygon.points.resize(256);
  TileShape group{.kind = TileShape::Kind::group, .parts = {polygon}};
  for (TileShape& shape : level.tile_shapes) shape = group;
  EXPECT_EQ(problem_of_amounts(level), std::nullopt);
  level.tile_shapes[0].parts.push_back({.kind = TileShape::Kind::slope, .heights = {0, 8}});
  EXPECT_EQ(problem_of_amounts(level),
            "has 1048578 heights and points of the shapes of tiles, but a level holds at most 1048576");
}

TEST(SheetSize, EditsOfUnknownTilesAreDropped) {
  const Level level = large();
  Edit edit{"Paint", {}};
  edit.changes.emplace_back(CellChange{{0, 0}, 0, 1000});
  edit.changes.emplace_back(CellChange{{1, 0}, 0, 999});
  edit.changes.emplace_back(FlagsChange{SheetId::tiles, 1000, 0, 1});
  edit.changes.emplace_back(FlagsChange{SheetId::sprites, 256, 0, 1});
  edit.changes.emplace_back(PixelChange{SheetId::tiles, 1000, 0, 0, 1});
  edit.changes.emplace_back(TileShapeChange{1000, {}, {.kind = TileShape::Kind::solid}});
  rebase_edit(level, edit);
  ASSERT_EQ(edit.changes.size(), 1u);
  EXPECT_EQ(std::get<CellChange>(edit.changes[0]).after, 999);
}

TEST(SheetSize, AreasAreCutAtTheSheet) {
  const Level level = large();
  const auto cut = [&](CellRect tiles) { return cut_to_sheet(level, {SheetId::tiles, tiles}).tiles; };
  EXPECT_EQ(cut({18, 48, 9, 9}), (CellRect{18, 48, 2, 2}));
  EXPECT_EQ(cut({30, 3, 2, 2}), CellRect{});
  EXPECT_EQ(cut_to_sheet(level, {SheetId::sprites, {15, 0, 3, 1}}).tiles, (CellRect{15, 0, 1, 1}));
  Level short_row = level;
  short_row.set_tile_layout({20, 990});
  EXPECT_EQ(cut_to_sheet(short_row, {SheetId::tiles, {8, 48, 9, 2}}).tiles, (CellRect{8, 48, 9, 1}));
}

TEST(SheetSize, ClipboardHoldsAllNumbers) {
  const Stamp stamp{2, 1, {999, 3}};
  EXPECT_EQ(text_of_cells(stamp), "wide map 2x1\n7e303000");
  EXPECT_EQ(cells_of_text(text_of_cells(stamp)), stamp);
  EXPECT_FALSE(cells_of_text("wide map 2x1\n7e3030"));
}

TEST(SheetSize, CartsRefuseOtherSheets) {
  Level level;
  level.set_tile_layout({16, 257});
  level.map.cells().tiles() = std::vector<TileNumber>(level.map.cells().tiles().size(), 256);
  level.map.set({0, 0}, 1);
  EXPECT_EQ(
      find_format("tic")->write(level, {}).error().message,
      "the sheet has 257 tiles, but that of a cart only 256; the map shows 2 of them, and a sheet of these "
      "alone would fit");
  level.map = TileMap(16, 17);
  for (int tile = 1; tile <= 256; ++tile)
    level.map.set({tile % 16, tile / 16}, static_cast<TileNumber>(tile));
  EXPECT_EQ(find_format("tic")->write(level, {}).error().message,
            "the sheet has 257 tiles, but that of a cart only 256; the map shows 256 of them");
  level.set_tile_layout({8, 256});
  EXPECT_EQ(find_format("tic")->write(level, {}).error().message,
            "the sheet has 8 columns of 256 tiles, but that of a cart has 16 columns of 256");
}

TEST(SheetSize, ExportsHaveAllTiles) {
  const Level level = large();
  EXPECT_THAT(exported("c", level, "cave.h")->files[0].bytes,
              testing::AllOf(HasSubstr("static const uint16_t cave_map["), HasSubstr("cave_flags[1000]")));
  EXPECT_THAT(exported("tmj", level, "cave.tmj")->files[0].bytes,
              testing::AllOf(HasSubstr("\"tilecount\": 1000"), HasSubstr("\"columns\": 20")));
  EXPECT_THAT(exported("lua", level, "cave.lua")->files[0].bytes, HasSubstr("[999]"));
}

}  // namespace talus::sheet_size_test
