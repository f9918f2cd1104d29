// Layers, objects, flags, tilesets and animations in plain data and in level.lua.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "export/lua_level.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "level/ground_level.h"
#include "paths.h"
#include "pictured_level.h"
#include "unit/exported_level.h"
#include "unit/program_output.h"

namespace talus::plain_layers_test {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A sky behind the ground, a turned tile, objects of all forms, and a wall that is one.
Level layered_level() {
  Level level = level_of_shapes({"....", "11.."});
  level.sheet(SheetId::tiles).flags[1] = 5;
  level.flag_names[2] = "ladder";
  level.animations[3] = {{3, 100}, {2, 50}};
  Tileset set{.name = "cave", .count = 16, .columns = 16};
  set.link = TilesetLink{.path = "cave.png"};
  level.tilesets = {set};
  level.map.cells().set(5, {1, TileTurn::left_right});
  level.layers.list.front().name = "ground";
  TileLayer sky{.name = "sky", .is_ground = false, .opacity = 0.5, .offset = {0, -2}};
  sky.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{3, 3, 0, 0, 0, 0, 0, 0});
  level.layers.list.insert(level.layers.list.begin(), sky);
  level.layers.chosen = 1;
  ObjectLayer clouds{.name = "clouds", .place = 0};
  clouds.image = LayerImage{"sky.png", plain_part(2, 2, kSky), true, false};
  ObjectLayer things{.name = "things", .offset = {1, 0}};
  things.objects = {
      {.name = "coin", .type = "money", .position = {8, 4}, .properties = R"({"5": {"worth": [1, true]}})"},
      {.type = "exit", .position = {8, 4}, .size = {8, 12}, .rotation = 90, .visible = false},
      {.form = MapObject::Form::polygon,
       .position = {4, 4},
       .rotation = 180,
       .points = {{0, 0}, {4, 0}, {0, 4}}},
      {.form = MapObject::Form::polyline, .position = {10, 4}, .points = {{0, 0}, {2, 0}}, .one_way = true},
      {.form = MapObject::Form::tile, .position = {8, 16}, .size = {4, 6}, .tile = 0xA0000007},
      {.form = MapObject::Form::ellipse, .size = {4, 6}},
      {.form = MapObject::Form::other, .size = {4, 6}}};
  ObjectLayer walls{.name = "walls", .is_ground = true};
  walls.objects = {{.name = "ledge", .position = {16, 4}, .size = {12, 3}}};
  level.objects = {clouds, things, walls};
  return level;
}

Exported made(const char* id, const Level& level) {
  const ReadAsset assets = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  return find_exporter(id)->make({level, "cave", assets}).value();
}

TEST(PlainLayers, AreAsTheLevelHasThem) {
  const Exported json = made("json", layered_level());
  EXPECT_THAT(json.dropped, IsEmpty());
  const Json data = Json::parse(json.files[0].bytes);
  EXPECT_GT(data["map"][0][2], 12) << "the wall makes tiles of its own in the map";
  EXPECT_EQ(data["layers"],
            Json::parse(R"([{"kind": "picture", "name": "clouds", "path": "sky.png", "repeats_x": true},
                {"kind": "tiles", "name": "sky", "opacity": 0.5, "y": -2, "map": [[3, 3, 0, 0], [0, 0, 0, 0]]},
                {"kind": "tiles", "name": "ground", "ground": true, "map": [[0, 0, 0, 0], [1, 1, 0, 0]],
                 "turns": [[0, 0, 0, 0], [0, 4, 0, 0]]},
                {"kind": "objects", "name": "things", "x": 1},
                {"kind": "objects", "name": "walls", "ground": true}])"));
  EXPECT_EQ(data["animations"], Json::parse(R"({"3": [3, 100, 2, 50]})"));
  EXPECT_EQ(data["tilesets"],
            Json::parse(R"([{"name": "cave", "first": 0, "count": 16, "columns": 16, "path": "cave.png"}])"));
  const Json plain = Json::parse(made("json", level_of_shapes({"1"})).files[0].bytes);
  for (const char* key : {"layers", "animations", "tilesets"}) EXPECT_FALSE(plain.contains(key)) << key;
}

TEST(PlainLayers, ObjectsSayWhatTheyAreAndWhere) {
  const Json objects = Json::parse(made("json", layered_level()).files[0].bytes)["objects"];
  ASSERT_EQ(objects.size(), 8U);
  EXPECT_EQ(objects[0], Json::parse(R"({"layer": "things", "form": "point", "class": "money", "name": "coin",
      "x": 9, "y": 4, "w": 0, "h": 0, "properties": {"5": {"worth": [1, true]}}})"));
  EXPECT_EQ(objects[1]["rotation"], 90);
  EXPECT_EQ(objects[1]["hidden"], true);
  EXPECT_EQ(objects[1]["properties"], Json::object());
  EXPECT_EQ(objects[2]["points"].size(), 6U);
  EXPECT_NEAR(objects[2]["points"][2].get<double>(), 1, 1e-12) << "rotated, with the layer's offset";
  EXPECT_FALSE(objects[2].contains("rotation"));
  EXPECT_EQ(objects[3]["points"], (Json{11, 4, 13, 4}));
  EXPECT_EQ(objects[3]["one_way"], true);
  EXPECT_EQ(objects[4]["y"], 10) << "its top";
  EXPECT_EQ(objects[4]["tile"], 7);
  EXPECT_EQ(objects[4]["turn"], 5) << "x and y change places, and then left and right";
  EXPECT_FALSE(objects[0].contains("tile"));
  std::vector<std::string> forms;
  for (const Json& object : objects) forms.push_back(object["form"]);
  EXPECT_THAT(forms, ElementsAre("point", "box", "polygon", "polyline", "tile", "ellipse", "other", "box"));
  EXPECT_EQ(objects[7]["ground"], true);
}

class LuaData : public FolderTest {
 protected:
  // Expects that both Luas print this for a script that has the exported data as `level`.
  void expect_printed(const std::string& data, const std::string& script, const std::string& expected) const {
    put("level.lua", data);
    put("script.lua", "local level = dofile('level.lua')\n" + script);
    for (const char* lua : {"lua5.3", "luajit"})
      EXPECT_EQ(output_of("cd '" + folder_.string() + "' && " + lua + " script.lua 2>&1"), expected) << lua;
  }
};

constexpr const char* kPrintObjects =
    "print(#level.objects, level.objects[1].class, level.objects[1].properties['5'].worth[2])\n";

TEST_F(LuaData, PlainLuaHasTheSame) {
  expect_printed(
      made("lua", layered_level()).files[0].bytes,
      std::string(kPrintObjects) +
          "print(level.layers[3].map[2][1], level.layers[3].turns[2][2], level.animations[3][4])\n",
      "8\tmoney\ttrue\n1\t4\t50\n");
}

TEST_F(LuaData, LevelsOfGamesHaveTheSame) {
  for (const char* id : {"lua-runtime", "love", "bump"}) {
    const Exported game = made(id, layered_level());
    EXPECT_THAT(game.dropped, Not(testing::Contains(HasSubstr("layer of objects")))) << id;
    for (const ExportedFile& file : game.files) {
      if (file.name != "level.lua") continue;
      expect_printed(file.bytes,
                     std::string(kPrintObjects) +
                         "local layers = {}\n"
                         "for _, layer in ipairs(level.layers) do\n"
                         "  if layer.tiles then layers[#layers + 1] = layer.name end\n"
                         "end\n"
                         "print(table.concat(layers, ' '), level.tile_flags[1], level.flag_names[2])\n"
                         "print(level.tilesets[1].path, level.animations[3][4], level.roles.solid)\n",
                     "8\tmoney\ttrue\nsky ground\t5\tladder\ncave.png\t50\t0\n");
    }
  }
  EXPECT_THAT(made("lua-runtime", layered_level()).dropped, ElementsAre(HasSubstr("layer of a picture")));
}

TEST_F(LuaData, MoreObjectsThanALuaJitFunctionHoldsAreRead) {
  Level level = level_of_shapes({"1"});
  ObjectLayer many{.name = "many"};
  for (int i = 0; i < 70'000; ++i) many.objects.push_back({.position = {1.0 * i, 0}});
  level.objects = {many};
  const std::string script = "print(#level.objects, level.objects[70000].x)\n";
  expect_printed(lua_level(level), script, "70000\t69999\n");
  expect_printed(made("lua", level).files[0].bytes, script, "70000\t69999\n");
}

TEST_F(LuaData, LayersWithMoreRowsThanALuaJitFunctionHoldsAreRead) {
  Level level;
  level.map = TileMap(1, 5000);
  TileLayer front{.name = "front", .is_ground = false};
  front.cells = std::make_shared<const MapCells>(std::vector<TileNumber>(5000, 7));
  for (int i = 0; i < 20; ++i) level.layers.list.push_back(front);
  expect_printed(made("lua", level).files[0].bytes,
                 "print(#level.layers, #level.layers[21].map, level.layers[21].map[5000][1])\n",
                 "21\t5000\t7\n");
}

TEST(PlainLayers, CartsHaveNoneOfThem) {
  const std::string small = lua_level(ground_level(layered_level()), LuaForm::small);
  for (const char* word : {"objects", "tile_flags", "flag_names", "tilesets", "layers", "money", "roles"})
    EXPECT_THAT(small, Not(HasSubstr(word)));
  EXPECT_THAT(lua_level(level_of_shapes({"1"})), Not(HasSubstr("layer_name")));
}

}  // namespace talus::plain_layers_test
