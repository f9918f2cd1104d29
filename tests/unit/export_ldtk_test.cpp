// Exported projects of LDtk, member by member; tests/games/ldtk_test checks them against schemas.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "export/exporter.h"
#include "export/map_png.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "formats/pictures/png_picture.h"
#include "paths.h"

namespace talus::export_ldtk_test {

using LdtkJson = nlohmann::json;

Exported exported(const Level& level, const std::string& name = "my cave.ldtk") {
  const ReadAsset assets = [](const std::string& asset) { return read_file(source_path("assets/") + asset); };
  auto out = find_exporter("ldtk")->write({level, name, assets});
  EXPECT_TRUE(out);
  return out.value_or(Exported());
}

LdtkJson project(const Level& level) { return LdtkJson::parse(exported(level).files.at(0).bytes); }

// 3x2 cells: a full tile and an up-slope over two tiles; below them a one-way tile, the same slope and a
// ball.
Level small_level() {
  Level level;
  level.map = TileMap(3, 2);
  level.map.cells().tiles() = {1, 2, 0, 5, 3, 4};
  level.sheet(SheetId::tiles).flags[1] = 1;
  level.sheet(SheetId::tiles).flags[4] = 2;
  for (const int tile : {2, 3})
    level.tile_shapes[tile] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 7.5}};
  level.tile_shapes[5] = {.kind = TileShape::Kind::solid, .one_way = true};
  return level;
}

TEST(ExportLdtk, IsAProjectAndTheSheetBesideIt) {
  const Exported out = exported(small_level());
  ASSERT_EQ(out.files.size(), 2U);
  EXPECT_EQ(out.files[0].name, "");
  EXPECT_EQ(out.files[1].name, "my cave-tiles.png");
  const auto sheet = read_png(out.files[1].bytes);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->width, 128);
  EXPECT_TRUE(out.dropped.empty());

  const LdtkJson json = LdtkJson::parse(out.files[0].bytes);
  EXPECT_EQ(json["jsonVersion"], "1.5.3");
  EXPECT_EQ(json["defaultLevelBgColor"], "#1A1C2C");
  const LdtkJson& tileset = json["defs"]["tilesets"][0];
  EXPECT_EQ(tileset["relPath"], "my cave-tiles.png");
  EXPECT_EQ(tileset["tileGridSize"], 8);
  const LdtkJson& level = json["levels"][0];
  EXPECT_EQ(level["identifier"], "my_cave");
  EXPECT_EQ(level["pxWid"], 24);
  EXPECT_EQ(level["pxHei"], 16);
  EXPECT_EQ(exported(small_level(), "-").files[1].name, "level-tiles.png");
}

TEST(ExportLdtk, AnAssetThatLacksAPartIsAnError) {
  for (const std::string text : {"", "[]", R"({"project": {}})", R"({"project": {}, "level": 1})"}) {
    const ReadAsset damaged = [&](const std::string&) -> FormatResult<std::string> { return text; };
    const auto out = find_exporter("ldtk")->write({small_level(), "cave.ldtk", damaged});
    ASSERT_FALSE(out) << text;
    EXPECT_EQ(out.error().place, "templates/ldtk.json");
  }
  const ReadAsset missing = [](const std::string& asset) -> FormatResult<std::string> {
    return tl::unexpected(FormatError{asset, "cannot be read"});
  };
  const auto out = find_exporter("ldtk")->write({small_level(), "cave.ldtk", missing});
  EXPECT_EQ(out.error().message, "cannot be read");
}

TEST(ExportLdtk, AnIntGridTellsTheShapes) {
  const LdtkJson json = project(small_level());
  const LdtkJson& values = json["defs"]["layers"][2]["intGridValues"];
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0]["identifier"], "solid");
  EXPECT_EQ(values[0]["value"], 1);
  EXPECT_EQ(values[1]["identifier"], "one_way");
  EXPECT_EQ(values[2]["identifier"], "slope_0_to_7p5_over_2_tiles");
  EXPECT_EQ(values[2]["value"], 3);
  const LdtkJson& layer = json["levels"][0]["layerInstances"][2];
  EXPECT_EQ(layer["__identifier"], "Collision");
  EXPECT_EQ(layer["__type"], "IntGrid");
  EXPECT_EQ(layer["__cWid"], 3);
  EXPECT_EQ(values[3]["identifier"], "slope_0_to_7p5_over_2_tiles_part_2");
  EXPECT_EQ(layer["intGridCsv"], LdtkJson({1, 3, 4, 2, 3, 4})) << "4: the slope's second cell";
}

// A cell with ground in it never has the value 0.
TEST(ExportLdtk, EveryCellThatAShapeReachesIntoHasAValue) {
  Level level = small_level();
  level.map = TileMap(3, 4);
  level.map.cells().tiles() = {0, 0, 0,  //
                               7, 0, 0,  //
                               0, 0, 1,  //
                               6, 0, 0};
  level.tile_shapes[6] = {.kind = TileShape::Kind::slope, .tiles = 3, .heights = {0, 24}};
  level.tile_shapes[7] = {.kind = TileShape::Kind::profile,
                          .side = TileShape::Side::ceiling,
                          .one_way = true,
                          .heights = {12, 20, 12}};
  const Exported out = exported(level);
  const LdtkJson json = LdtkJson::parse(out.files[0].bytes);
  std::vector<std::string> names = {"0"};
  for (const LdtkJson& value : json["defs"]["layers"][2]["intGridValues"])
    names.push_back(value["identifier"]);
  std::vector<std::string> cells;
  for (const LdtkJson& value : json["levels"][0]["layerInstances"][2]["intGridCsv"])
    cells.push_back(names.at(value.get<std::size_t>()));
  const std::string wide = "slope_0_to_24_over_3_tiles", hanging = "one_way_ceiling_profile_of_tile_7";
  EXPECT_EQ(cells, (std::vector<std::string>{"0", "0", "0",                                               //
                                             hanging, "0", wide + "_part_3_row_3",                        //
                                             hanging + "_part_1_row_2", wide + "_part_2_row_2", "solid",  //
                                             wide, wide + "_part_2", wide + "_part_3"}));
  EXPECT_EQ(out.dropped, std::vector<std::string>{"a second shape in 1 cell that two shapes reach into"});
}

TEST(ExportLdtk, ShapesOfOtherKindsHaveValuesOfTheirOwn) {
  Level level = small_level();
  level.tile_shapes[6] = {.kind = TileShape::Kind::profile, .heights = {0, 3, 8}};
  level.tile_shapes[7] = {
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .one_way = true, .heights = {8, 0}};
  level.tile_shapes[8] = {.kind = TileShape::Kind::slope, .heights = {1, -4}};  // invalid
  const LdtkJson values = project(level)["defs"]["layers"][2]["intGridValues"];
  ASSERT_EQ(values.size(), 6U);
  EXPECT_EQ(values[4]["identifier"], "profile_of_tile_6");
  EXPECT_EQ(values[5]["identifier"], "one_way_ceiling_slope_8_to_0");
}

TEST(ExportLdtk, TilesAreAtTheirPlacesOnTheMap) {
  const LdtkJson json = project(small_level());
  const LdtkJson& layer = json["levels"][0]["layerInstances"][1];
  EXPECT_EQ(layer["__type"], "Tiles");
  EXPECT_EQ(layer["__tilesetRelPath"], "my cave-tiles.png");
  // The tiles 0, 2, 3 and 5 have neither pixels nor flags, and tile 4 is a ball.
  ASSERT_EQ(layer["gridTiles"].size(), 1U);
  EXPECT_EQ(layer["gridTiles"][0].dump(), R"({"a":1,"d":[0],"f":0,"px":[0,0],"src":[8,0],"t":1})");
  Level drawn = small_level();
  drawn.sheet(SheetId::tiles).images[0][3] = 7;
  drawn.map.cells().tiles()[5] = 255;
  drawn.sheet(SheetId::tiles).flags[255] = 128;
  const LdtkJson tiles = project(drawn)["levels"][0]["layerInstances"][1]["gridTiles"];
  ASSERT_EQ(tiles.size(), 3U);
  EXPECT_EQ(tiles[1]["t"], 0);
  EXPECT_EQ(tiles[2]["src"], LdtkJson({120, 120}));
}

// In 16 colours it is all of colour 0, which is the nearest to its own.
TEST(ExportLdtk, ADarkTileInTrueColourIsNotEmpty) {
  Level level = small_level();
  SheetPicture picture{128, 128, std::vector<std::uint8_t>(std::size_t{4} * 128 * 128)};
  picture.rgba[4 * 16 + 3] = 255;  // a black pixel of tile 2
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(picture);
  const LdtkJson tiles = project(level)["levels"][0]["layerInstances"][1]["gridTiles"];
  ASSERT_EQ(tiles.size(), 2U);
  EXPECT_EQ(tiles[1]["t"], 2);
}

TEST(ExportLdtk, CustomDataHoldFlagsAndHeights) {
  const LdtkJson json = project(small_level());
  const LdtkJson& data = json["defs"]["tilesets"][0]["customData"];
  ASSERT_EQ(data.size(), 5U);
  EXPECT_EQ(data[0]["tileId"], 1);
  EXPECT_EQ(data[0]["data"],
            R"({"flags":1,"kind":"solid","one_way":false,"tiles":1,"floor":[0,0,0,0,0,0,0,0]})");
  const LdtkJson slope = LdtkJson::parse(data[1]["data"].get<std::string>());
  EXPECT_EQ(slope["kind"], "slope");
  EXPECT_EQ(slope["tiles"], 2);
  ASSERT_EQ(slope["floor"].size(), 16U);
  EXPECT_EQ(slope["floor"][0], 8 - 7.5 * 0.5 / 16);
  EXPECT_EQ(data[3]["tileId"], 4);
  EXPECT_EQ(data[3]["data"], R"({"flags":2,"ball":true})");
}

TEST(ExportLdtk, SpawnsAreEntities) {
  Level level = small_level();
  Spawn& ball = level.spawns.emplace_back();
  ball.name = "Wheel \"1\"";
  ball.position = {3.75, -2.5};
  ball.velocity = {0.1, 0};
  ball.size = {0.25, 12};
  level.spawns.emplace_back().kind = BodyKind::player;
  level.map.set({2, 1}, 0);  // removes the ball tile
  const LdtkJson json = project(level);
  const LdtkJson& definitions = json["defs"]["entities"];
  ASSERT_EQ(definitions.size(), 5U);
  EXPECT_EQ(definitions[0]["identifier"], "Ball");
  EXPECT_EQ(definitions[1]["identifier"], "Player");
  EXPECT_EQ(definitions[2]["identifier"], "Crate");
  EXPECT_EQ(definitions[3]["identifier"], "Disc");
  EXPECT_EQ(definitions[4]["identifier"], "Marble");
  ASSERT_EQ(definitions[1]["fieldDefs"].size(), 9U);
  EXPECT_EQ(definitions[1]["fieldDefs"][7]["identifier"], "foot");
  EXPECT_EQ(definitions[1]["fieldDefs"][7]["type"], "F_String");

  const LdtkJson& entities = json["levels"][0]["layerInstances"][0]["entityInstances"];
  ASSERT_EQ(entities.size(), 2U);
  EXPECT_EQ(entities[0]["px"], LdtkJson({4, -3}));
  EXPECT_EQ(entities[0]["__grid"], LdtkJson({0, -1}));
  EXPECT_EQ(entities[0]["width"], 1);
  EXPECT_EQ(entities[0]["height"], 12);
  EXPECT_EQ(entities[0]["defUid"], definitions[0]["uid"]);
  const LdtkJson& fields = entities[0]["fieldInstances"];
  EXPECT_EQ(fields[0]["__value"], "Wheel \"1\"");
  EXPECT_EQ(fields[1]["__value"], 3.75);
  EXPECT_EQ(fields[5]["__identifier"], "vx");
  EXPECT_EQ(fields[5]["realEditorValues"].dump(), R"([{"id":"V_Float","params":[0.1]}])");
  EXPECT_EQ(entities[1]["__identifier"], "Player");
  EXPECT_EQ(entities[1]["fieldInstances"][7]["__value"], "centre");
  EXPECT_NE(entities[0]["iid"], entities[1]["iid"]);
}

// The entities have the picture of the tile, and the layer of tiles leaves it out.
TEST(ExportLdtk, BallTilesAreEntities) {
  const LdtkJson json = project(small_level());
  const LdtkJson& entities = json["levels"][0]["layerInstances"][0]["entityInstances"];
  ASSERT_EQ(entities.size(), 1U);
  EXPECT_EQ(entities[0]["__identifier"], "Ball");
  EXPECT_EQ(entities[0]["px"], LdtkJson({16, 8}));
  EXPECT_EQ(entities[0]["__tile"].dump(), R"({"h":8,"tilesetUid":1,"w":8,"x":32,"y":0})");
  const LdtkJson& field = entities[0]["fieldInstances"][8];
  EXPECT_EQ(field["__identifier"], "tile");
  EXPECT_EQ(field["__type"], "Tile");
  EXPECT_EQ(field["__value"], entities[0]["__tile"]);
  EXPECT_EQ(field["realEditorValues"].dump(), R"([{"id":"V_String","params":["32,0,8,8"]}])");
}

TEST(ExportLdtk, CurvesAreReportedAsDropped) {
  Level level = small_level();
  level.curves.push_back({"", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""});
  EXPECT_EQ(exported(level).dropped, std::vector<std::string>{"1 curve"});
}

MapObject coin(Vec2 position, const char* properties) {
  MapObject object;
  object.name = "a \"coin\"";
  object.type = "Coin";
  object.position = position;
  object.size = {4, 6.5};
  object.properties = properties;
  return object;
}

// A layer in front of the tiles, and one behind them.
Level level_with_objects() {
  Level level = small_level();
  ObjectLayer& front = level.objects.emplace_back();
  front.name = "Old coins";
  front.opacity = 0.5;
  front.objects = {coin({2.25, 3}, R"({"value": 3, "key": "red", "x": true, "deep": [1]})"),
                   coin({8, 3}, R"({"value": 2.5, "key": 5})")};
  ObjectLayer& back = level.objects.emplace_back();
  back.place = 0;
  back.visible = false;
  MapObject& path = back.objects.emplace_back();
  path.form = MapObject::Form::polyline;
  path.type = "hero";
  path.position = {8, 8};
  path.points = {{0, 0}, {-4, 2.5}};
  return level;
}

// By name, what an entity says.
LdtkJson values_of(const LdtkJson& entity) {
  LdtkJson values;
  for (const LdtkJson& field : entity["fieldInstances"]) values[field["__identifier"]] = field["__value"];
  return values;
}

TEST(ExportLdtk, LayersOfObjectsHaveTheirPlaces) {
  const Exported out = exported(level_with_objects());
  EXPECT_TRUE(out.dropped.empty());
  const LdtkJson json = LdtkJson::parse(out.files[0].bytes);
  const LdtkJson& definitions = json["defs"]["layers"];
  const LdtkJson& layers = json["levels"][0]["layerInstances"];
  std::vector<std::string> names, defined;
  for (const LdtkJson& layer : layers) names.push_back(layer["__identifier"]);
  for (const LdtkJson& layer : definitions) defined.push_back(layer["identifier"]);
  EXPECT_EQ(names, (std::vector<std::string>{"Bodies", "Old_coins", "Tiles", "Collision", "Objects"}));
  EXPECT_EQ(names, defined);
  EXPECT_EQ(definitions[1]["doc"], "Old coins");
  EXPECT_EQ(definitions[1]["displayOpacity"], 0.5);
  EXPECT_EQ(layers[1]["__opacity"], 0.5);
  EXPECT_EQ(layers[1]["visible"], true);
  EXPECT_EQ(layers[4]["visible"], false);
}

TEST(ExportLdtk, ObjectsAreEntitiesWithFields) {
  const LdtkJson json = project(level_with_objects());
  const LdtkJson& layers = json["levels"][0]["layerInstances"];
  const LdtkJson &first = layers[1]["entityInstances"][0], &second = layers[1]["entityInstances"][1];
  EXPECT_EQ(first["__identifier"], "Coin");
  EXPECT_EQ(first["px"], LdtkJson({2, 3}));
  EXPECT_EQ(first["width"], 4);
  EXPECT_EQ(values_of(first), LdtkJson::parse(R"({"form": "box", "class": "Coin", "name": "a \"coin\"",
      "x": 2.25, "y": 3, "w": 4, "h": 6.5, "rotation": 0, "tile": null, "turn": null, "points": null, "ground": false, "one_way": false,
      "hidden": false, "value": 3, "key": "red", "x_2": true, "deep": "[1]"})"));
  EXPECT_EQ(values_of(second)["value"], 2.5);
  EXPECT_EQ(values_of(second)["key"], "5") << "others have text there";
  EXPECT_FALSE(values_of(second).contains("deep"));
  const LdtkJson& path = layers[4]["entityInstances"][0];
  EXPECT_EQ(path["__identifier"], "hero_object") << "which is no body";
  EXPECT_EQ(path["px"], LdtkJson({4, 8}));
  EXPECT_EQ(path["width"], 4);
  EXPECT_EQ(values_of(path)["points"], "[8,8,4,10.5]");
}

TEST(ExportLdtk, AClassOfObjectsHasOneDefinition) {
  const LdtkJson all = project(level_with_objects())["defs"]["entities"];
  ASSERT_EQ(all.size(), 7U);
  EXPECT_EQ(all[5]["identifier"], "Coin");
  std::map<std::string, std::string> types;
  for (const LdtkJson& field : all[5]["fieldDefs"]) types[field["identifier"]] = field["type"];
  EXPECT_EQ(types.size(), 18U);
  EXPECT_EQ(types["value"], "F_Float");
  EXPECT_EQ(types["key"], "F_String");
  EXPECT_EQ(types["x_2"], "F_Bool");
  EXPECT_EQ(types["one_way"], "F_Bool");
}

TEST(ExportLdtk, LayersOfPicturesAndLooksAreTold) {
  Level level = level_with_objects();
  level.objects[0].parallax = {0.5, 1};
  level.objects.emplace_back().image.emplace();
  const ReadAsset assets = [](const std::string& asset) { return read_file(source_path("assets/") + asset); };
  const auto out = find_exporter("ldtk")->make({level, "a.ldtk", assets});
  ASSERT_TRUE(out);
  EXPECT_EQ(out->dropped, (std::vector<std::string>{"the parallax of the layer \"Old coins\"",
                                                    "the layer of a picture \"\""}));
}

TEST(ExportLdtk, TheSameLevelGivesTheSameFile) {
  EXPECT_EQ(exported(small_level()).files[0].bytes, exported(small_level()).files[0].bytes);
}

// As much as can be edited and saved, but more than is read as JSON.
TEST(LargeExportLdtk, IsRefusedIfItCannotBeReadAgain) {
  Level level = small_level();
  level.map = TileMap(1200, 1200);
  for (TileNumber& tile : level.map.cells().tiles()) tile = 1;
  const ReadAsset assets = [](const std::string& asset) { return read_file(source_path("assets/") + asset); };
  const auto out = find_exporter("ldtk")->write({level, "m.ldtk", assets});
  ASSERT_FALSE(out);
  EXPECT_EQ(
      out.error().message,
      "the project of LDtk has more lines and numbers than Talus reads from one file: tmx holds larger maps");
}

class ExportedLdtk : public FolderTest {
 protected:
  Level read_back(const Level& level) const {
    const Exported out = exported(level);
    put("cave.ldtk", out.files[0].bytes);
    put(out.files[1].name, out.files[1].bytes);
    const auto read = load_level(path("cave.ldtk"));
    EXPECT_TRUE(read) << read.error().message;
    return read ? read->level : Level();
  }
};

TEST_F(ExportedLdtk, ReadBackItHasTheSamePicture) {
  Level level = small_level();
  level.map.cells().tiles() = {1, 0, 5, 1, 1, 0};  // ground with pictures alone
  for (const int tile : {1, 5}) level.sheet(SheetId::tiles).images[tile].fill(6);
  Level again = read_back(level);
  EXPECT_EQ(again.background, background_of(level));
  again.background.reset();  // which pictures leave out
  const auto before = read_rgba(map_png(level).value()), after = read_rgba(map_png(again).value());
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->bytes, after->bytes) << "the colours of the ground lie below the tiles";
}

TEST_F(ExportedLdtk, ReadBackItHasBodiesOfTheSameKinds) {
  Level level = small_level();
  level.map.set({2, 1}, 0);  // removes the ball tile
  for (const BodyTraits& kind : body_kinds()) {
    Spawn& spawn = level.spawns.emplace_back();
    spawn.kind = *find_body_kind(kind.word);
    spawn.name = kind.word;
    spawn.position = {8.0 * static_cast<double>(level.spawns.size()), 4};
    spawn.size = {6, 7};
  }
  const Level again = read_back(level);
  ASSERT_EQ(again.spawns.size(), level.spawns.size());
  for (std::size_t i = 0; i < again.spawns.size(); ++i) {
    EXPECT_EQ(again.spawns[i].kind, level.spawns[i].kind);
    EXPECT_EQ(again.spawns[i].name, level.spawns[i].name);
    EXPECT_EQ(again.spawns[i].position, level.spawns[i].position);
    EXPECT_EQ(again.spawns[i].size, level.spawns[i].size);
  }
}

TEST_F(ExportedLdtk, ReadBackItHasTheSameObjects) {
  Level level = level_with_objects();
  MapObject& tile = level.objects[0].objects.emplace_back();
  tile.form = MapObject::Form::tile;
  tile.position = {3.5, 9};
  tile.size = {0, 4.25};
  tile.anchor = {0, 0};
  tile.tile = 0xA0000007;
  tile.rotation = 12.5;
  tile.visible = false;
  level.objects[0].objects[1].properties = R"({"key":"5","value":2.5})";  // as its class has it
  level.objects[0].objects[0].properties = R"({"deep":"[1]","key":"red","value":3})";
  const Level again = read_back(level);
  ASSERT_EQ(again.objects.size(), 2U);
  EXPECT_EQ(again.objects[0].name, "Objects");
  EXPECT_EQ(again.objects[0].place, 0);
  EXPECT_FALSE(again.objects[0].visible);
  EXPECT_EQ(again.objects[0].objects, level.objects[1].objects);
  EXPECT_EQ(again.objects[1].opacity, 0.5);
  EXPECT_EQ(again.objects[1].objects, level.objects[0].objects);
}

TEST_F(ExportedLdtk, WhatLdtkMovedIsThere) {
  const Exported out = exported(level_with_objects());
  LdtkJson json = LdtkJson::parse(out.files[0].bytes);
  LdtkJson& layers = json["levels"][0]["layerInstances"];
  layers[1]["entityInstances"][0]["px"] = {9, 3};
  layers[1]["entityInstances"][0]["width"] = 20;
  layers[4]["entityInstances"][0]["px"] = {5, 10};
  put("cave.ldtk", json.dump());
  put(out.files[1].name, out.files[1].bytes);
  const auto read = load_level(path("cave.ldtk"));
  ASSERT_TRUE(read) << read.error().message;
  const MapObject& moved = read->level.objects.at(1).objects.at(0);
  EXPECT_EQ(moved.position, (Vec2{9, 3}));
  EXPECT_EQ(moved.size, (Vec2{20, 6.5}));
  EXPECT_EQ(read->level.objects[0].objects.at(0).position, (Vec2{9, 10})) << "by 1 and 2 px";
}

}  // namespace talus::export_ldtk_test
