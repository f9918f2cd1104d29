// What hostile projects of LDtk ask for is counted before it is made.
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "formats/ldtk/ldtk_tiles.h"
#include "ldtk_text.h"

namespace talus::import_ldtk_limits_test {

std::string error_of(const std::string& text) {
  FormatContext context{"ldtk"};
  const auto loaded = read_level(text, context);
  return loaded ? "" : to_string(loaded.error(), "file");
}

std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += (i > 0 ? "," : "") + text;
  return all;
}

// A level of one layer of such cells, with a tileset whose tiles have that side.
std::string project_of(int columns, int rows, int side, int tile_side, const std::string& tiles) {
  const std::string layer =
      ldtk_layer("Tiles", "T", columns, rows, R"("__tilesetDefUid":1,"gridTiles":[)" + tiles + "]", side);
  return ldtk_project(ldtk_level(layer), "",
                      R"({"uid":1,"identifier":"Big","tileGridSize":)" + std::to_string(tile_side) + "}");
}

TEST(ImportLdtkLimits, PartsAndPixelsAreCounted) {
  EXPECT_EQ(error_of(project_of(4096, 1025, 1, 4096, ldtk_tile(0, 0, 0))),
            "file: error: shows too many tiles: all cells together may show parts of 4194304");
  EXPECT_EQ(
      error_of(project_of(1, 1, 256, 256, times(4096, ldtk_tile(0, 0, 0, 0, "0.5")))),
      "file: error: shows too many different tiles: their parts in cells may have up to 268435456 pixels "
      "together");
}

class LdtkTileStacks : public FolderTest {};

TEST_F(LdtkTileStacks, OfThousandsAreOpenedAndSaved) {
  const std::string file = put(
      "g.ldtk", project_of(2, 1, 8, 8, times(5000, ldtk_tile(0, 0, 3, 0, "0.5")) + "," + ldtk_tile(8, 0, 1)));
  auto loaded = load_level(file);
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "g.ldtk");
  const TileNumber stack = loaded->level.map.tile_at({0, 0});
  EXPECT_NE(stack, loaded->level.map.tile_at({1, 0}));
  loaded->level.map.set({1, 0}, stack);
  ASSERT_TRUE(save_level(loaded->level, *loaded->format, file, loaded->companion));
  const auto again = load_level(file);
  ASSERT_TRUE(again) << to_string(again.error(), "g.ldtk");
  EXPECT_EQ(again->level, loaded->level);
  EXPECT_EQ(again->level.map.tile_at({0, 0}), stack);
}

TEST_F(LdtkTileStacks, OfTooManyAreRefused) {
  EXPECT_EQ(error_of(project_of(1, 1, 1, 1, times(kMaxLdtkCellParts + 1, ldtk_tile(0, 0, 0, 0, "0.5")))),
            "file: error: shows too many tiles over one another: a cell may show 65536");
}

// A project may be made to take long by the data of one tile that is shown often.
TEST_F(LdtkTileStacks, ReadTheDataOfATileOnce) {
  const std::string data =
      R"("customData":[{"tileId":0,"data":"{\"a\":1,\"b\":1}"},{"tileId":1,"data":"{\"a\":2}"}])";
  const std::string layer =
      ldtk_tiles(1, 1, times(3000, ldtk_tile(0, 0, 0, 0, "0.5")) + "," + ldtk_tile(0, 0, 1, 0, "0.5"));
  const auto loaded = read_level(ldtk_project(ldtk_level(layer), "", ldtk_tileset(data)), {"ldtk"});
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "file");
  const TileNumber tile = loaded->level.map.tile_at({0, 0});
  EXPECT_EQ(note_of(loaded->level.tile_notes, tile).properties, R"({"a":2,"b":1})");
}

TEST(ImportLdtkLimits, LayersAreCountedBeforeTheyAreMade) {
  constexpr const char* kError =
      "file: error: has too many layers: a level has up to 100, of up to 67108864 cells together";
  const auto error_of_layers = [](std::size_t count, int side) {
    const std::string layer =
        ldtk_layer("Tiles", "T", side, side, R"("gridTiles":[)" + ldtk_tile(0, 0, 0) + "]");
    return error_of(ldtk_project(ldtk_level(times(count, layer))));
  };
  EXPECT_EQ(error_of_layers(100, 1), "");
  EXPECT_EQ(error_of_layers(101, 1), kError);
  EXPECT_EQ(error_of_layers(5, 4096), kError);
}

TEST(ImportLdtkLimits, FarTilesCostNothing) {
  const std::string tiles = ldtk_tile(67108864, -67108864, 0) + "," + ldtk_tile(-67108864, 0, 0);
  EXPECT_EQ(error_of(project_of(2, 2, 8, 4096, tiles)), "");
}

TEST(ImportLdtkLimits, SizesOfMapsAreLimited) {
  EXPECT_EQ(
      error_of(project_of(4097, 4096, 8, 8, "")),
      "file: error: has 4097x4096 cells, but a level has 1 to 16777216 of them, and is at most 16777216 px "
      "long");
  EXPECT_EQ(
      error_of(project_of(0, 1, 8, 8, "")),
      "file: error: has 0x1 cells, but a level has 1 to 16777216 of them, and is at most 16777216 px long");
}

TEST(ImportLdtkLimits, TilesetsLayersAndLevelsAreCounted) {
  EXPECT_EQ(error_of(ldtk_project(ldtk_level(""), "", times(kMaxLdtkTilesets + 1, ldtk_tileset()))),
            "file:key defs.tilesets[4096]: error: is one tileset too many: a project may have at most 4096");
  EXPECT_EQ(
      error_of(ldtk_project(ldtk_level(times(kMaxLdtkLayers + 1, ldtk_tiles(1, 1, ""))))),
      "file:key levels[0].layerInstances[4096]: error: is one layer too many: a project may have at most "
      "4096");
  EXPECT_EQ(error_of(ldtk_project(times(kMaxLdtkLevels + 1, R"({"identifier":"L","pxWid":8,"pxHei":8})"))),
            "file:key levels[65536]: error: is one level too many: a project may have at most 65536");
}

TEST(ImportLdtkLimits, NamesInMessagesAreCut) {
  const std::string long_name(100'000, 'n');
  const std::string project = ldtk_project(ldtk_level("", long_name) + "," + ldtk_level("", long_name));
  EXPECT_LT(error_of(project).size(), 400u);
}

}  // namespace talus::import_ldtk_limits_test
