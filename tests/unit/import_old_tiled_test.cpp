// Maps as they are found: written by old versions of Tiled, beside tilesets that have changed since.
#include <gmock/gmock.h>

#include <algorithm>

#include "folder_test.h"
#include "formats/pictures/png_picture.h"

namespace talus::import_old_tiled_test {

using testing::Contains;
using testing::HasSubstr;

// Tiled 1.0 wrote properties, and tiles with their properties, as objects.
const std::string kOldTileset =
    R"({"name":"t","tilewidth":16,"tileheight":16,"columns":2,"tilecount":4,"firstgid":1,
"properties":{"p":1},"propertytypes":{"p":"int"},
"tiles":{"2":{"objectgroup":{"type":"objectgroup","properties":{},"objects":
  [{"id":1,"x":0,"y":8,"width":16,"height":8,"properties":{"one_way":true},"propertytypes":{"one_way":"bool"}}]}},
 "10":{"terrain":[0,0,0,0]}},
"tileproperties":{"0":{"spiky":true},"2":{"spiky":true,"depth":2}},
"tilepropertytypes":{"0":{"spiky":"bool"},"2":{"spiky":"bool","depth":"int"}}})";
const std::string kOldMap =
    R"({"orientation":"orthogonal","width":2,"height":1,"tilewidth":16,"tileheight":16,"version":1,
"properties":{"music":"a.ogg"},"propertytypes":{"music":"string"},"tilesets":[)" +
    kOldTileset + R"(],"layers":[
{"name":"l","type":"tilelayer","width":2,"height":1,"data":[3,1],
 "properties":{"collidable":false},"propertytypes":{"collidable":"bool"}},
{"name":"front","type":"tilelayer","width":2,"height":1,"data":[0,3]},
{"name":"o","type":"objectgroup","objects":[{"id":1,"name":"a","x":1,"y":2,"width":3,"height":4,
  "properties":{"n":5},"propertytypes":{"n":"int"}}]}]})";

Level read(const std::string& text, const std::string& extension) {
  const auto loaded = read_level(text, {extension});
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
  return loaded ? loaded->level : Level();
}

TEST(ImportOldTiled, PropertiesMayBeObjects) {
  const Level level = read(kOldMap, "json");
  EXPECT_FALSE(level.layers.list[0].is_ground);
  EXPECT_TRUE(level.layers.list[1].is_ground);
  ASSERT_EQ(level.objects.size(), 1U);
  EXPECT_THAT(level.objects[0].objects.at(0).properties, HasSubstr("\"n\""));
}

TEST(ImportOldTiled, TilesMayBeAnObject) {
  const Level level = read(kOldMap, "json");
  const TileNumber shaped = level.cells_of(1).tiles()[1];
  EXPECT_EQ(level.tile_shapes[shaped],
            (TileShape{.kind = TileShape::Kind::slope, .one_way = true, .heights = {8, 8}}));
  const auto& names = level.flag_names;
  const auto spiky = std::find(names.begin(), names.end(), "spiky") - names.begin();
  EXPECT_EQ(level.tile_flags(shaped), 1 << spiky);
  EXPECT_EQ(level.tile_flags(level.cells_of(0).tiles()[1]), 1 << spiky);
}

TEST(ImportOldTiled, TilesetsMayBeAlone) {
  const Level level = read(kOldTileset, "json");
  EXPECT_THAT(level.flag_names, Contains("spiky"));
  EXPECT_TRUE(std::any_of(level.tile_shapes.begin(), level.tile_shapes.end(),
                          [](const TileShape& shape) { return shape.one_way; }));
}

TEST(ImportOldTiled, WrongTilesAreTold) {
  std::string text = kOldTileset;
  text.replace(text.find("\"10\""), 4, "\"ten\"");
  const auto loaded = read_level(text, {"json"});
  ASSERT_FALSE(loaded);
  EXPECT_EQ(to_string(loaded.error(), "t.json"), "t.json:key tiles[2].id: error: must have a number as id");
}

class ImportTilesets : public FolderTest {
 protected:
  // A map of these layers of two cells, which are 2x2 px.
  std::string map_of(const std::string& tilesets, const std::vector<std::string>& layers) const {
    std::string text =
        "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"2\" tileheight=\"2\">" +
        tilesets;
    for (const std::string& cells : layers)
      text +=
          "<layer name=\"l\" width=\"2\" height=\"1\"><data encoding=\"csv\">" + cells + "</data></layer>";
    return text + "</map>";
  }
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
};

TEST_F(ImportTilesets, HaveNoTilesWithNumbersOfTheNextOne) {
  const std::string size = "tilewidth=\"2\" tileheight=\"2\" columns=\"2\"";
  put("a.tsx", "<tileset name=\"a\" " + size + " tilecount=\"5\"/>");
  const std::string text = map_of(
      "<tileset firstgid=\"1\" source=\"a.tsx\"/>"
      "<tileset firstgid=\"4\" name=\"b\" " +
          size + " tilecount=\"2\"/>",
      {"1,0"});
  put("m.tmx", text);
  const LoadedLevel loaded = load("m.tmx");
  EXPECT_THAT(loaded.dropped,
              Contains("the last tiles of the tileset \"a\", from number 3 on: their numbers are "
                       "those of the next tileset"));
  const auto saved = save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion);
  ASSERT_TRUE(saved) << to_string(saved.error(), "m.tmx");
  EXPECT_EQ(bytes_of("m.tmx"), text);
}

TEST_F(ImportTilesets, ATileThatIsFaintlySeenIsNotTheEmptyOne) {
  std::vector<std::uint8_t> pixels;  // of three tiles: opaque, faint, clear
  for (int y = 0; y < 2; ++y) {
    for (const int alpha : {255, 255, 100, 100, 0, 0})
      pixels.insert(pixels.end(), {0, 0, 0, static_cast<std::uint8_t>(alpha)});
  }
  put("t.png", encode_png(6, 2, 4, pixels.data()));
  put("m.tmx", map_of("<tileset firstgid=\"1\" name=\"t\" tilewidth=\"2\" tileheight=\"2\" tilecount=\"3\" "
                      "columns=\"3\"><image source=\"t.png\" width=\"6\" height=\"2\"/></tileset>",
                      {"1,1", "0,1"}));
  const Level level = load("m.tmx").level;
  ASSERT_EQ(level.cells_of(1)[0], 0);
  const auto picture = level.sheet(SheetId::tiles).picture;
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->at(0, 0)[3], 0);
}

TEST_F(ImportTilesets, ATileOfTheBackgroundHidesWhatIsBehind) {
  const Rgb background = default_palette()[0];
  std::vector<std::uint8_t> pixels;  // of two tiles: that colour, and red
  for (int y = 0; y < 2; ++y) {
    for (const Rgb c : {background, background, Rgb{255, 0, 0}, Rgb{255, 0, 0}})
      pixels.insert(pixels.end(), {c.r, c.g, c.b, 255});
  }
  put("t.png", encode_png(4, 2, 4, pixels.data()));
  put("m.tmx", map_of("<tileset firstgid=\"1\" name=\"t\" tilewidth=\"2\" tileheight=\"2\" tilecount=\"2\" "
                      "columns=\"2\"><image source=\"t.png\" width=\"4\" height=\"2\"/></tileset>",
                      {"2,2", "0,1"}));
  const Level level = load("m.tmx").level;
  EXPECT_NE(level.cells_of(1)[0], level.cells_of(1)[1]);
}

TEST_F(ImportTilesets, AMapWithoutEmptyCellsHasAnEmptyTile) {
  const std::vector<std::uint8_t> red = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};
  put("t.png", encode_png(2, 2, 4, red.data()));
  const std::string text = map_of(
      "<tileset firstgid=\"1\" name=\"t\" tilewidth=\"2\" tileheight=\"2\" tilecount=\"1\" "
      "columns=\"1\"><image source=\"t.png\" width=\"2\" height=\"2\"/></tileset>",
      {"1,1"});
  put("m.tmx", text);
  LoadedLevel loaded = load("m.tmx");
  EXPECT_NE(loaded.level.map.at({0, 0}), 0);
  loaded.level.map.set({1, 0}, 0);
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(">1,0<"));
}

}  // namespace talus::import_old_tiled_test
