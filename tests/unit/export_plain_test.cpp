// Plain data in Lua, JSON and CSV: exact on small levels, and readable by Lua 5.3 and LuaJIT.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include <talus/sim/scene.h>
#include <talus/sim/state.h>
#include "export/plain_data.h"
#include "folder_test.h"
#include "formats/native/native.h"
#include "unit/exported_level.h"
#include "unit/program_output.h"

namespace talus::export_plain_test {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A slope under a platform, a wide slope, a curve and a player.
Level cave() {
  Level level = level_of_shapes({".7..", ".2..", "1115"});
  level.sheet(SheetId::tiles).flags[1] = 1;
  level.sheet(SheetId::tiles).flags[255] = 130;
  level.sheet(SheetId::sprites).flags[0] = 255;
  level.curves.push_back({"bow", {Segment{{0, 4}, {4, 2.5}}, Curve::Faces::both}, ""});
  Spawn& spawn = level.spawns.emplace_back();
  spawn.name = "a \"b\",\nc\\";
  spawn.kind = BodyKind::player;
  spawn.position = {0.1, 2};
  spawn.velocity = {-1, 0.5};
  return level;
}

Json json_of(const Level& level) { return Json::parse(exported_file("json", level)); }

TEST(ExportJson, HoldsMapAndFlags) {
  const Json json = json_of(cave());
  EXPECT_EQ(json["width"], 4);
  EXPECT_EQ(json["height"], 3);
  EXPECT_EQ(json["tile_size"], 8);
  EXPECT_EQ(json["tile_width"], 8);
  EXPECT_EQ(json["tile_height"], 8);
  EXPECT_EQ(json["map"], (Json{{0, 7, 0, 0}, {0, 2, 0, 0}, {1, 1, 1, 5}}));
  EXPECT_EQ(json["flags"]["tiles"].size(), 256U);
  EXPECT_EQ(json["flags"]["tiles"][1], 1);
  EXPECT_EQ(json["flags"]["tiles"][255], 130);
  EXPECT_EQ(json["flags"]["sprites"].size(), 256U);
  EXPECT_EQ(json["flags"]["sprites"][0], 255);
  EXPECT_EQ(json["roles"], (Json{{"solid", 0}, {"ball", 1}, {"up_slope", 2}, {"down_slope", 3}}));
}

TEST(ExportJson, HoldsFloorsByColumnOfPixels) {
  const Json shapes = json_of(cave())["shapes"];
  EXPECT_EQ(shapes.size(), 12U);
  EXPECT_EQ(shapes["1"],
            (Json{{"kind", "solid"}, {"one_way", false}, {"tiles", 1}, {"floor", {0, 0, 0, 0, 0, 0, 0, 0}}}));
  EXPECT_EQ(shapes["2"]["floor"], (Json{7.5, 6.5, 5.5, 4.5, 3.5, 2.5, 1.5, 0.5}));
  EXPECT_EQ(shapes["4"]["kind"], "profile");
  EXPECT_EQ(shapes["4"]["floor"], (Json{7, 5, 3.5, 2.5, 2.5, 3.5, 5, 7}));
  EXPECT_EQ(shapes["5"]["tiles"], 3);
  EXPECT_EQ(shapes["5"]["floor"].size(), 24U);
  EXPECT_NEAR(shapes["5"]["floor"][23].get<double>(), 1.0 / 6, 1e-15);
  EXPECT_EQ(shapes["6"]["ceiling"], (Json{0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5}));
  EXPECT_FALSE(shapes["6"].contains("floor"));
  EXPECT_EQ(shapes["7"]["one_way"], true);
  EXPECT_EQ(shapes["9"]["floor"][63], 8 - 63.5);
}

TEST(ExportJson, HoldsPolygonsLinesAndBodies) {
  const Json json = json_of(cave());
  EXPECT_EQ(json["polygons"].size(), 2U);
  EXPECT_EQ(json["polygons"][0],
            (Json{{"hole", false}, {"points", {0, 16, 8, 16, 16, 8, 16, 16, 24, 16, 24, 24, 0, 24}}}));
  EXPECT_EQ(json["polygons"][1], (Json{{"hole", false}, {"points", {24, 24, 48, 16, 48, 24}}}));
  EXPECT_EQ(json["lines"],
            (Json{{{"kind", "one_way"}, {"name", ""}, {"both_sides", false}, {"points", {8, 0, 16, 0}}},
                  {{"kind", "curve"}, {"name", "bow"}, {"both_sides", true}, {"points", {0, 4, 4, 2.5}}}}));
  EXPECT_EQ(json["bodies"].size(), 1U);
  EXPECT_EQ(json["bodies"][0], (Json{{"id", 1},
                                     {"name", "a \"b\",\nc\\"},
                                     {"kind", "player"},
                                     {"x", 0.1},
                                     {"y", 2},
                                     {"w", 8},
                                     {"h", 8},
                                     {"vx", -1},
                                     {"vy", 0.5},
                                     {"foot", "centre"}}));
}

TEST(ExportJson, AnEmptyMapHasEmptyLists) {
  Level level;
  level.map = TileMap(2, 1);
  const std::string text = exported_file("json", level);
  EXPECT_THAT(text,
              StartsWith("{\n \"width\":2,\n \"height\":1,\n \"tile_size\":8,\n \"tile_width\":8,\n "
                         "\"tile_height\":8,\n \"background\":[26,28,44,255],\n \"map\":[\n  [0,0]\n ],\n"));
  EXPECT_THAT(text, HasSubstr(" \"shapes\":{},\n \"objects\":[],\n \"polygons\":[],\n \"lines\":[],\n "
                              "\"bodies\":[],\n \"tuning\":{"));
}

// The data are written as in a level's file, and a body has the id that it has in the simulation.
TEST(ExportJson, HoldsBallTilesAsBodiesAndTheTuning) {
  Level level = cave();
  level.sheet(SheetId::tiles).flags[60] = level.sheet(SheetId::tiles).flags[61] = 2;
  level.map.set({3, 0}, 60);
  level.map.set({2, 1}, 61);
  level.map.set({0, 1}, 61);
  level.tuning.solver = SolverKind::bump;
  level.tuning.shared.fall_speed = 3.25;
  level.tuning.exact.gravity =
      0.5;  // so that the group is written, as files leave out groups with only standard numbers
  level.tuning.player.gravity = 0.1;
  const Json json = json_of(level);
  ASSERT_EQ(json["bodies"].size(), 4U);
  EXPECT_EQ(json["bodies"][0], (Json{{"id", 1},
                                     {"name", ""},
                                     {"kind", "ball"},
                                     {"x", 0},
                                     {"y", 8},
                                     {"w", 8},
                                     {"h", 8},
                                     {"vx", 0},
                                     {"vy", 0},
                                     {"foot", "box"},
                                     {"tile", 61}}));
  const State state = initial_state(compile_scene(level));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(json["bodies"][i]["id"], state.bodies[i].id);
    EXPECT_EQ(json["bodies"][i]["x"], state.bodies[i].box.x);
    EXPECT_EQ(json["bodies"][i]["y"], state.bodies[i].box.y);
  }
  EXPECT_EQ(json["bodies"][2]["tile"], 60);
  EXPECT_FALSE(json["bodies"][3].contains("tile"));
  EXPECT_EQ(json["tuning"], Json::parse(write_native(level, {})->bytes)["tuning"]);
}

// ---- Lines ----

using Points = std::vector<Vec2>;

TEST(PlainLines, OneWayTilesAreJoinedAndStopAtGround) {
  const auto lines = plain_lines(level_of_shapes({"77.7", "..2.", "7717"}));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].points, (Points{{0, 0}, {16, 0}}));
  EXPECT_EQ(lines[1].points, (Points{{0, 16}, {16, 16}}));
  EXPECT_EQ(lines[2].points, (Points{{24, 0}, {32, 0}}));
  EXPECT_EQ(lines[3].points, (Points{{24, 16}, {32, 16}}));
}

TEST(PlainLines, OneWayCeilingsGoToTheLeft) {
  Level level = level_of_shapes({"66"});
  level.tile_shapes[6].one_way = true;
  const auto lines = plain_lines(level);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].points, (Points{{8, 8}, {0, 0}}));
}

TEST(PlainLines, CurvesThatFaceDownGoToTheLeft) {
  Level level;
  level.curves.push_back({"", {Polyline{0, 8, {4, 6, 4}}, Curve::Faces::down}, ""});
  EXPECT_EQ(plain_lines(level), (std::vector<PlainLine>{{true, false, "", {{8, 4}, {4, 6}, {0, 4}}}}));
}

TEST(PlainLines, CurvesStayNear) {
  Level level;
  level.curves.push_back({"", {Arc{{50, 50}, 40, 10, 90, true}, Curve::Faces::up}, ""});
  const Points points = plain_lines(level).at(0).points;
  EXPECT_EQ(points.front(), (Vec2{10, 50}));
  EXPECT_EQ(points.back(), (Vec2{90, 50}));
  EXPECT_LT(points.size(), 100U);
  double most = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_LT(points[i].x, points[i + 1].x);
    const Vec2 middle = (points[i] + points[i + 1]) * 0.5;
    most = std::max(most, std::abs(std::hypot(middle.x - 50, middle.y - 50) - 40));
  }
  EXPECT_LE(most, kPlainLineError);
  EXPECT_GT(most, kPlainLineError / 100);
}

// ---- Lua ----

class ExportLuaData : public FolderTest {
 protected:
  // Expects that both Luas print this for a script that has the level as `level`.
  void expect_lua(const Level& level, const std::string& script, const std::string& expected) const {
    put("cave.lua", exported_file("lua", level));
    put("script.lua", "local level = dofile('cave.lua')\n" + script);
    for (const char* lua : {"lua5.3", "luajit"})
      EXPECT_EQ(output_of("cd '" + folder_.string() + "' && " + lua + " script.lua 2>&1"), expected) << lua;
  }
};

TEST_F(ExportLuaData, RunsInLuaAndLuaJit) {
  expect_lua(cave(), R"(
print(level.width, level.height, level.tile_size, #level.map, #level.map[3], level.map[3][4])
print(level.flags.tiles[1 + 1], level.flags.tiles[255 + 1], #level.flags.sprites, level.flags.sprites[1])
print(level.roles.down_slope, level.roles.ceiling)
print(level.shapes[2].kind, level.shapes[2].one_way, table.concat(level.shapes[2].floor, " "))
print(level.shapes[6].floor, level.shapes[6].ceiling[8], level.shapes[7].one_way, level.shapes[0])
print(#level.polygons, level.polygons[1].hole, table.concat(level.polygons[1].points, " "))
print(#level.lines, level.lines[1].kind, level.lines[2].name, table.concat(level.lines[2].points, " "))
print(#level.bodies, level.bodies[1].name == 'a "b",\nc\\', level.bodies[1].x == 0.1, level.bodies[1].foot)
print(level.tuning.solver, level.tuning.fall_blend == 0.075, level.tuning.exact.steepest, level.tuning.player.jump_speed)
)",
             "4\t3\t8\t3\t4\t5\n"
             "1\t130\t256\t255\n"
             "3\tnil\n"
             "slope\tfalse\t7.5 6.5 5.5 4.5 3.5 2.5 1.5 0.5\n"
             "nil\t7.5\ttrue\tnil\n"
             "2\tfalse\t0 16 8 16 16 8 16 16 24 16 24 24 0 24\n"
             "2\tone_way\tbow\t0 4 4 2.5\n"
             "1\ttrue\ttrue\tcentre\n"
             "exact\ttrue\t2\t3.5\n");
}

TEST_F(ExportLuaData, MoreTablesThanALuaJitFunctionHoldsAreRead) {
  Level level;
  level.map = TileMap(400, 200);
  level.tile_shapes = test_shapes();
  for (Cell c; c.y < 200; ++c.y)
    for (c.x = 0; c.x < 400; ++c.x) level.map.set(c, static_cast<TileNumber>((c.x + c.y) % 2));
  expect_lua(level,
             "print(#level.map, level.map[200][1], #level.polygons)\n"
             "print(table.concat(level.polygons[1].points, ' '))\n"
             "print(table.concat(level.polygons[40000].points, ' '))\n",
             "200\t1\t40000\n0 8 8 8 8 16 0 16\n3192 1584 3200 1584 3200 1592 3192 1592\n");
}

// ---- CSV ----

TEST(ExportCsv, IsAFolderOfTables) {
  const auto files = exported("csv", cave(), "tables");
  ASSERT_TRUE(files);
  std::vector<std::string> names;
  for (const ExportedFile& file : files->files) names.push_back(file.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"map.csv", "flags.csv", "sprite_flags.csv", "polygons.csv", "lines.csv",
                                      "bodies.csv", "roles.csv", "tuning.csv", "sizes.csv"}));
  EXPECT_EQ(exported_file("csv", cave(), "map.csv"), "0,7,0,0\n0,2,0,0\n1,1,1,5\n");
}

TEST(ExportJson, GivesTheSizeOfOtherTiles) {
  Level level;
  level.map = TileMap(2, 2, {18, 12});
  level.map.set({1, 1}, 1);
  level.sheet(SheetId::tiles).flags[1] = 1;
  const Json json = json_of(level);
  EXPECT_FALSE(json.contains("tile_size")) << "they are not square";
  EXPECT_EQ(json["tile_width"], 18);
  EXPECT_EQ(json["tile_height"], 12);
  EXPECT_EQ(json["polygons"][0]["points"], (Json{18, 12, 36, 12, 36, 24, 18, 24}));
  EXPECT_EQ(json["shapes"]["1"]["floor"].size(), 18U);
  EXPECT_THAT(exported_file("csv", level, "sizes.csv"), HasSubstr("tile_width,18,px\ntile_height,12,px\n"));
  EXPECT_THAT(exported_file("csv", level, "flags.csv"), HasSubstr(",y16,y17\n0,0,none"));
}

TEST(ExportCsv, ConveyorsAreDroppedWithAWarning) {
  const Level level = level_of_conveyors();
  EXPECT_EQ(exported("csv", level, "cave")->dropped, std::vector<std::string>{"the speeds of 3 conveyors"});
  EXPECT_TRUE(exported("json", level, "cave")->dropped.empty());
}

TEST(ExportCsv, HasARowForEachTileAndForEachColumnOfCells) {
  const std::string text = exported_file("csv", cave(), "flags.csv");
  EXPECT_THAT(text, StartsWith("tile,flags,kind,side,one_way,tiles,column,y0,y1,y2,y3,y4,y5,y6,y7\n"
                               "0,0,none,,,,,,,,,,,,\n"
                               "1,1,solid,floor,0,1,0,0,0,0,0,0,0,0,0\n"
                               "2,0,slope,floor,0,1,0,7.5,6.5,5.5,4.5,3.5,2.5,1.5,0.5\n"));
  EXPECT_THAT(text, HasSubstr("\n6,0,slope,ceiling,0,1,0,0.5,1.5,2.5,3.5,4.5,5.5,6.5,7.5\n"));
  EXPECT_THAT(text, HasSubstr("\n7,0,solid,floor,1,1,0,0,0,0,0,0,0,0,0\n"));
  EXPECT_THAT(text,
              HasSubstr("\n9,0,slope,floor,0,8,7,-48.5,-49.5,-50.5,-51.5,-52.5,-53.5,-54.5,-55.5\n10,"));
  EXPECT_THAT(text, HasSubstr("\n255,130,none,,,,,,,,,,,,\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 256 + 2 + 7 + 1);  // wide tiles 5, 9 and 10
  EXPECT_THAT(exported_file("csv", cave(), "sprite_flags.csv"), StartsWith("sprite,flags\n0,255\n1,0\n"));
}

TEST(ExportCsv, HoldsPolygonsLinesAndBodies) {
  Level level = level_of_shapes({"7", "1"});
  EXPECT_EQ(exported_file("csv", level, "polygons.csv"),
            "polygon,hole,point,x,y\n0,0,0,0,8\n0,0,1,8,8\n0,0,2,8,16\n0,0,3,0,16\n");
  EXPECT_EQ(exported_file("csv", level, "lines.csv"),
            "line,kind,name,both_sides,point,x,y\n0,one_way,,0,0,0,0\n0,one_way,,0,1,8,0\n");
  EXPECT_EQ(exported_file("csv", level, "bodies.csv"), "id,name,kind,tile,x,y,w,h,vx,vy,foot\n");
  level = cave();
  level.sheet(SheetId::tiles).flags[60] = 2;
  level.map.set({3, 0}, 60);
  EXPECT_EQ(exported_file("csv", level, "bodies.csv"),
            "id,name,kind,tile,x,y,w,h,vx,vy,foot\n1,,ball,60,24,0,8,8,0,0,box\n"
            "2,\"a \"\"b\"\",\nc\\\",player,,0.1,2,8,8,-1,0.5,centre\n");
}

TEST(ExportCsv, HoldsRolesAndTuning) {
  EXPECT_EQ(exported_file("csv", cave(), "roles.csv"),
            "role,flag\nsolid,0\nup_slope,2\ndown_slope,3\nball,1\n");
  const std::string text = exported_file("csv", cave(), "tuning.csv");
  EXPECT_THAT(text, StartsWith("name,value,unit\nsolver,exact,\ncell_size,24,px\nfall_speed,5,px/frame\n"));
  EXPECT_THAT(text, HasSubstr("\nexact.gravity,0,px/frame^2\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + static_cast<int>(tuning_fields().size()));
}

}  // namespace talus::export_plain_test
