// What maps of Tiled show besides tiles of their cells' size: large tiles, objects with pictures, image
// layers.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "formats/text/base64.h"
#include "png_bytes.h"

namespace talus::import_layers_test {

using testing::ElementsAre;

class ImportLayers : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    put("t.png", rgb_png(16, std::vector<Rgb>(16 * 32, Rgb{255, 0, 0})));
    put("sky.png", rgb_png(4, std::vector<Rgb>(4 * 2, Rgb{0, 0, 255})));
  }
  // A map of 2x2 cells of 16x16 px with a tileset of one tile of 16x32 px.
  Level read(const std::string& layers, const std::string& map = "", const std::string& tileset = "") const {
    put("map.tmx",
        "<map orientation=\"orthogonal\" width=\"2\" height=\"2\" tilewidth=\"16\" "
        "tileheight=\"16\" " +
            map + "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"16\" tileheight=\"32\" " +
            "tilecount=\"1\" columns=\"1\" " + tileset + "><image source=\"t.png\"/></tileset>" + layers +
            "</map>");
    auto loaded = load_level(path("map.tmx"));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
    return loaded ? loaded->level : Level();
  }
};

const std::string kTiles = "<layer name=\"l\"><data encoding=\"csv\">0,0,1,0</data></layer>";

TEST_F(ImportLayers, ATallTileHasItsWholePicture) {
  const Level level = read(kTiles);
  ASSERT_EQ(level.large_tiles.size(), 1u);
  const LargeTile& tile = level.large_tiles.at(level.map.tile_at({0, 1}));
  EXPECT_EQ(tile.size, (TileSize{16, 32}));
  EXPECT_EQ(tile.part.height, 32);
  EXPECT_EQ(tile.part.picture->height, 32);
  EXPECT_TRUE(read(kTiles, "renderorder=\"left-up\"").layers.order == RenderOrder::left_up);
}

TEST_F(ImportLayers, ATileThatFitsTheGridIsScaled) {
  const Level level = read(kTiles, "", "tilerendersize=\"grid\" fillmode=\"preserve-aspect-fit\"");
  const LargeTile& tile = level.large_tiles.at(level.map.tile_at({0, 1}));
  EXPECT_EQ(tile.size, (TileSize{16, 16}));
  EXPECT_TRUE(tile.part.keeps_ratio);
}

TEST_F(ImportLayers, ObjectsKeepHowTheirLayerLooks) {
  const Level level = read(
      "<objectgroup name=\"behind\" opacity=\"0.5\" offsetx=\"3\" parallaxy=\"0.5\" locked=\"1\" "
      "tintcolor=\"#ff8000\" draworder=\"index\"><object x=\"1\" y=\"2\" visible=\"0\"/></objectgroup>" +
      kTiles + "<objectgroup name=\"front\"><object x=\"1\" y=\"2\"/></objectgroup>");
  ASSERT_EQ(level.objects.size(), 2u);
  const ObjectLayer& behind = level.objects[0];
  EXPECT_EQ(behind.opacity, 0.5);
  EXPECT_EQ(behind.offset, (Vec2{3, 0}));
  EXPECT_EQ(behind.parallax, (Vec2{1, 0.5}));
  EXPECT_EQ(behind.tint, (Rgb{255, 128, 0}));
  EXPECT_TRUE(behind.locked);
  EXPECT_FALSE(behind.by_y);
  EXPECT_EQ(behind.place, 0);
  EXPECT_EQ(behind.objects[0].position, (Vec2{1, 2})) << "without the offset of the layer";
  EXPECT_FALSE(behind.objects[0].visible);
  EXPECT_EQ(level.objects[1].place, 1);
  EXPECT_TRUE(level.objects[1].by_y);
}

TEST_F(ImportLayers, ATileObjectHasThePictureOfItsTile) {
  const std::string object =
      "<objectgroup><object gid=\"2147483649\" x=\"8\" y=\"32\" width=\"8\" height=\"16\"/></objectgroup>";
  const MapObject shown = read(kTiles + object).objects[0].objects[0];
  EXPECT_EQ(shown.picture.width, 16);
  EXPECT_TRUE(shown.picture.mirrors_x);
  EXPECT_EQ(shown.anchor, (Vec2{0, 1}));
  EXPECT_EQ(read(kTiles + object, "", "objectalignment=\"top\"").objects[0].objects[0].anchor,
            (Vec2{0.5, 0}));
}

// Pictures in the text of the map itself.
TEST_F(ImportLayers, PicturesInsideOfTheMapAreShown) {
  const std::string png = encode_base64(rgb_png(1, {Rgb{9, 8, 7}}));
  put("in.tmx",
      "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"1\" tileheight=\"1\"><tileset "
      "firstgid=\"1\" name=\"t\" tilewidth=\"1\" tileheight=\"1\" tilecount=\"1\" columns=\"1\"><image "
      "format=\"png\"><data encoding=\"base64\">\n " +
          png + "\n</data></image></tileset><layer name=\"l\"><data encoding=\"csv\">1</data></layer>" +
          "<imagelayer name=\"sky\"><image format=\"png\"><data encoding=\"base64\">" + png +
          "</data></image></imagelayer></map>");
  const auto loaded = load_level(path("in.tmx"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "in");
  const auto& picture = loaded->level.objects.at(0).image->part.picture;
  ASSERT_NE(picture, nullptr);
  EXPECT_THAT(picture->rgba, ElementsAre(9, 8, 7, 255));
  EXPECT_EQ(loaded->level.objects[0].image->path, "");
  EXPECT_THAT(loaded->dropped, testing::Each(testing::Not(testing::HasSubstr("picture"))));
}

TEST_F(ImportLayers, TheOpacityOfATintCounts) {
  const Level level = read(
      "<layer name=\"l\" opacity=\"0.5\" tintcolor=\"#80ff0000\"><data "
      "encoding=\"csv\">0,0,1,0</data></layer>" +
      kTiles);
  EXPECT_EQ(level.layers.list.at(0).tint, (Rgb{128, 0, 0}));
  EXPECT_NEAR(level.layers.list.at(0).opacity, 0.25, 0.01);
}

TEST_F(ImportLayers, APictureMayBeLongerThanASheet) {
  put("sky.png", rgb_png(40'000, std::vector<Rgb>(40'000, Rgb{0, 0, 255})));
  const Level level = read("<imagelayer name=\"sky\"><image source=\"sky.png\"/></imagelayer>" + kTiles);
  EXPECT_EQ(level.objects.at(0).image->part.width, 40'000);
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
  const auto again = load_level(path("level.talus.json"));
  ASSERT_TRUE(again) << to_string(again.error(), "level");
  EXPECT_EQ(again->level.objects, level.objects);
}

TEST_F(ImportLayers, AnImageLayerKeepsItsPicture) {
  const Level level = read(
      "<imagelayer name=\"sky\" repeatx=\"1\" offsety=\"-4\"><image source=\"sky.png\" "
      "trans=\"0000ff\"/></imagelayer>" +
      kTiles);
  ASSERT_EQ(level.objects.size(), 1u);
  const ObjectLayer& sky = level.objects[0];
  EXPECT_EQ(sky.name, "sky");
  EXPECT_EQ(sky.offset, (Vec2{0, -4}));
  ASSERT_TRUE(sky.image);
  EXPECT_EQ(sky.image->path, "sky.png");
  EXPECT_TRUE(sky.image->repeats_x);
  EXPECT_FALSE(sky.image->repeats_y);
  EXPECT_EQ(sky.image->part.width, 4);
  EXPECT_EQ(sky.image->part.picture->at(0, 0)[3], 0) << "its colour is transparent";
}

// As Tiled 1.8.2 draws them.
TEST_F(ImportLayers, APictureHasTheXAndYOfOldMapsWithoutAnOffset) {
  const auto offset_with = [&](const std::string& attributes) {
    return read("<imagelayer name=\"sky\" " + attributes + "><image source=\"sky.png\"/></imagelayer>" +
                kTiles)
        .objects.at(0)
        .offset;
  };
  EXPECT_EQ(offset_with("x=\"16\" y=\"8\""), (Vec2{16, 8}));
  EXPECT_EQ(offset_with("x=\"16\" y=\"8\" offsetx=\"16\" offsety=\"8\""), (Vec2{16, 8}));
  EXPECT_EQ(offset_with("x=\"16\" y=\"8\" offsetx=\"4\""), (Vec2{4, 0}));
  EXPECT_EQ(offset_with("x=\"16\" y=\"8\" offsety=\"0\""), (Vec2{0, 0}));
}

}  // namespace talus::import_layers_test
