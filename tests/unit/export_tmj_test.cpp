// Maps of Tiled in JSON, value by value.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "formats/pictures/png_sheet.h"
#include "tiled_files.h"

namespace talus::export_tmj_test {

using Json = nlohmann::json;
using testing::ElementsAre;

Json exported() { return Json::parse(tiled_export_of(level_for_tiled(), "tmj", "cave.tmj").files[0].bytes); }

Json tile(int id) {
  const Json map = exported();
  for (const Json& tile : map["tilesets"][0]["tiles"]) {
    if (tile["id"] == id) return tile;
  }
  return {};
}

// A line "name type value" for each property.
std::string words(const Json& properties) {
  std::string text;
  for (const Json& p : properties)
    text +=
        p["name"].get<std::string>() + " " + p["type"].get<std::string>() + " " + p["value"].dump() + "\n";
  return text;
}

TEST(ExportTmj, HoldsAMapAsTiledReadsIt) {
  const Json map = exported();
  EXPECT_EQ(map["type"], "map");
  EXPECT_EQ(map["orientation"], "orthogonal");
  EXPECT_EQ(map["infinite"], false);
  EXPECT_EQ(map["backgroundcolor"], "#1a1c2c") << "colour 0";
  EXPECT_EQ(map["width"], 6);
  EXPECT_EQ(map["height"], 4);
  EXPECT_EQ(map["tilewidth"], 8);
  EXPECT_EQ(map["nextlayerid"], 4);
  EXPECT_EQ(map["nextobjectid"], 5);
  const Json& layer = map["layers"][0];
  EXPECT_EQ(layer["type"], "tilelayer");
  EXPECT_EQ(layer["opacity"], 1);
  EXPECT_EQ(layer["visible"], true);
  EXPECT_EQ(layer["data"],
            Json::parse("[0,0,0,0,0,0, 0,0,5,0,6,0, 0,3,4,8,0,7, 2,2,2,2,2,2]"));  // tile 0 is blank
}

TEST(ExportTmj, HasATilesetWithItsPictureBesideIt) {
  const Level level = level_for_tiled();
  const Exported files = tiled_export_of(level, "tmj", "cave.tmj");
  ASSERT_EQ(files.files.size(), 2u);
  EXPECT_EQ(files.files[0].name, "");
  EXPECT_EQ(files.files[1].name, "cave-tiles.png");
  EXPECT_EQ(files.files[1].bytes, write_png_part(level, PngPart::tiles));
  EXPECT_THAT(files.dropped, ElementsAre());
  const Json set = exported()["tilesets"][0];
  EXPECT_EQ(set["image"], "cave-tiles.png");
  EXPECT_EQ(set["imagewidth"], 128);
  EXPECT_EQ(set["columns"], 16);
  EXPECT_EQ(set["tilecount"], 256);
  EXPECT_EQ(set["firstgid"], 1);
}

TEST(ExportTmj, TilesHaveFlagsByNumberAndByName) {
  EXPECT_EQ(words(tile(1)["properties"]), "flags int 1\nsolid bool true\nshape string \"solid\"\n");
  EXPECT_EQ(words(tile(3)["properties"]), "flags int 16\nice bool true\n");
  EXPECT_EQ(words(tile(7)["properties"]),
            "flags int 33\nsolid bool true\nflag5 bool true\nshape string \"solid\"\n");
  EXPECT_TRUE(tile(9).is_null()) << "a tile without properties has no entry";
}

TEST(ExportTmj, ShapesArePolygonsWithWords) {
  const Json solid = tile(1)["objectgroup"]["objects"][0];
  EXPECT_EQ(solid["width"], 8);
  EXPECT_EQ(solid["height"], 8);
  EXPECT_FALSE(solid.contains("polygon"));
  EXPECT_EQ(tile(2)["objectgroup"]["objects"][0]["polygon"],
            Json::parse(R"([{"x":0,"y":8},{"x":16,"y":0},{"x":16,"y":8}])"));
  EXPECT_EQ(words(tile(2)["properties"]),
            "flags int 4\nup_slope bool true\nshape string \"slope\"\nshape_heights string \"0 8\"\n");
  EXPECT_EQ(tile(4)["objectgroup"]["objects"][0]["polygon"],
            Json::parse(R"([{"x":0,"y":2},{"x":4,"y":0.5},{"x":8,"y":4},{"x":8,"y":0},{"x":0,"y":0}])"));
  EXPECT_EQ(words(tile(4)["properties"]),
            "shape string \"profile\"\nshape_heights string \"2 0.5 4\"\nshape_side string \"ceiling\"\n");
  EXPECT_EQ(tile(5)["objectgroup"]["objects"][0]["polygon"],
            Json::parse(R"([{"x":0,"y":6.99609375},{"x":16,"y":-12},{"x":16,"y":8},{"x":0,"y":8}])"));
  EXPECT_EQ(words(tile(5)["properties"]),
            "shape string \"slope\"\nshape_heights string \"1.00390625 20\"\nshape_one_way bool true\n");
  EXPECT_EQ(words(tile(5)["objectgroup"]["objects"][0]["properties"]), "one_way bool true\n");
  EXPECT_FALSE(tile(4)["objectgroup"]["objects"][0].contains("properties"));
}

TEST(ExportTmj, BodiesAreObjects) {
  const Json layer = exported()["layers"][1];
  EXPECT_EQ(layer["name"], "spawns");
  EXPECT_EQ(layer["type"], "objectgroup");
  const Json& player = layer["objects"][0];
  EXPECT_EQ(player["type"], "player");
  EXPECT_EQ(player["name"], "a <b> & \"c\"");
  EXPECT_EQ(player["x"], 12.3456789);
  EXPECT_EQ(player["height"], 12);
  EXPECT_EQ(words(player["properties"]), "vx float 0.1\nvy float -3\nfoot string \"centre\"\n");
  EXPECT_EQ(layer["objects"][1]["type"], "ball");
}

TEST(ExportTmj, CurvesAreLinesNoFurtherOffThanTheTolerance) {
  const Json layer = exported()["layers"][2];
  const Json& ramp = layer["objects"][0];
  EXPECT_EQ(ramp["polyline"], Json::parse(R"([{"x":0,"y":0},{"x":7.75,"y":6.5}])"));
  EXPECT_EQ(words(ramp["properties"]),
            "kind string \"segment\"\nfaces string \"both\"\nx0 float 1.25\ny0 float 2\nx1 float 9\ny1 float "
            "8.5\n");
  const Json& hill = layer["objects"][1];
  const Json& line = hill["polyline"];
  EXPECT_EQ(words(hill["properties"]),
            "kind string \"arc\"\nfaces string \"up\"\nx float 24\ny float 24\nradius float 12\nx0 float 12\n"
            "x1 float 36\nupper bool true\n");
  EXPECT_EQ(line.back(), Json::parse(R"({"x":24,"y":0})"));
  EXPECT_LT(line.size(), 40u);
  for (std::size_t i = 1; i < line.size();
       ++i) {  // the middle of a chord has the largest distance to the circle
    const double x = (line[i - 1]["x"].get<double>() + line[i]["x"].get<double>()) / 2 - 12;
    const double y = (line[i - 1]["y"].get<double>() + line[i]["y"].get<double>()) / 2;
    EXPECT_NEAR(std::hypot(x, y), 12, 0.125);
  }
}

TEST(ExportTmj, WarnsOfWhatIsDropped) {
  EXPECT_THAT(tiled_export_of(level_for_tiled(), "tmj", "-").dropped,
              ElementsAre("the picture level-tiles.png, which goes beside a file"));
}

TEST(ExportTmj, ADrawnTile0IsNotEmpty) {
  Level level = level_for_tiled();
  level.sheet(SheetId::tiles).images[0][5] = 1;
  const Json map = Json::parse(tiled_export_of(level, "tmj", "a.tmj").files[0].bytes);
  EXPECT_EQ(map["layers"][0]["data"][0], 1);
}

// In 16 colours it is all of colour 0, which is the nearest to its own.
TEST(ExportTmj, ADarkTile0InTrueColourIsNotEmpty) {
  Level level = level_for_tiled();
  SheetPicture picture{128, 128, std::vector<std::uint8_t>(std::size_t{4} * 128 * 128)};
  picture.rgba[3] = 255;  // a black pixel
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(picture);
  const Json map = Json::parse(tiled_export_of(level, "tmj", "a.tmj").files[0].bytes);
  EXPECT_EQ(map["layers"][0]["data"][0], 1);
}

}  // namespace talus::export_tmj_test
