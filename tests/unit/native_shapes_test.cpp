// Shapes, curves, players and the numbers of solvers in native levels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include <talus/formats/format.h>
#include "native_text.h"
#include "paths.h"

namespace talus::native_shapes_test {

using testing::HasSubstr;
using testing::Not;

void expect_error(const std::string& members, const std::string& place, const std::string& message) {
  expect_native_error(native_with(members), place, message);
}

TEST(NativeShapes, NeighbouringCornersAreRoundedApart) {
  const auto with_corner_at = [](const char* x) {
    return R"("tile_shapes": {"1": {"kind": "polygon", "points": [[0, 8], [)" + std::string(x) +
           ", 8], [8, 8], [8, 0]]}}";
  };
  EXPECT_EQ(level_of_native(native_with(with_corner_at("0.003"))).tile_shapes[1].points.size(), 4U);
  expect_error(with_corner_at("0.0019"), "key tile_shapes.1",
               "has two neighbouring points at the same place, rounded to 1/256 px");
}

Level level_with_everything() {
  Level level;
  level.tile_shapes[12] = {.kind = TileShape::Kind::slope,
                           .side = TileShape::Side::ceiling,
                           .one_way = true,
                           .tiles = 2,
                           .heights = {0, 8}};
  level.tile_shapes[200] = {.kind = TileShape::Kind::solid};
  level.flag_shapes[6] = {.kind = TileShape::Kind::profile, .heights = {0, 2.5, 0}};
  level.roles.one_way = 7;
  level.curves = {{"hill", {Arc{{100, 100}, 64, 60, 140, true}, Curve::Faces::up}, ""},
                  {"", {Arc{{100, 100}, 20, 80, 120, false}, Curve::Faces::both}, ""},
                  {"", {Segment{{0, 10}, {50, 20.25}}, Curve::Faces::down}, ""},
                  {"", {Parabola{{0, 10}, {50, 20}, -3}, Curve::Faces::up}, ""},
                  {"", {Cubic{{0, 10}, {50, 20}, 0.5, -1}, Curve::Faces::up}, ""},
                  {"", {Sine{0, 64, 30, 8, 64, 0}, Curve::Faces::up}, ""},
                  {"", {Polyline{0, 8, {1, 2, 0.5}}, Curve::Faces::up}, R"({"colour":"red"})"}};
  level.spawns = {{"hero", {8, 8}, {}, "", BodyKind::player, {6, 12.5}, Foot::box}};
  level.tuning.solver = SolverKind::exact;
  level.tuning.exact.substeps = 4;
  return level;
}

TEST(NativeShapes, AreWrittenAsInThisFile) {
  const std::string text = native_of_level(level_with_everything());
  EXPECT_THAT(text, HasSubstr(R"(
  "flag_shapes": {
    "6": {"kind": "profile", "heights": [0, 2.5, 0]}
  },)"));
  EXPECT_THAT(text, HasSubstr(R"(
  "tile_shapes": {
    "12": {"kind": "slope", "side": "ceiling", "one_way": true, "tiles": 2, "heights": [0, 8]},
    "200": {"kind": "solid"}
  },)"));
  EXPECT_THAT(text, HasSubstr(R"(
  "curves": [
    {"name": "hill", "kind": "arc", "center": [100, 100], "radius": 64, "x0": 60, "x1": 140},
    {"kind": "arc", "faces": "both", "center": [100, 100], "radius": 20, "x0": 80, "x1": 120, "upper": false},
    {"kind": "segment", "faces": "down", "from": [0, 10], "to": [50, 20.25]},
    {"kind": "parabola", "from": [0, 10], "to": [50, 20], "control_y": -3},
    {"kind": "cubic", "from": [0, 10], "to": [50, 20], "from_slope": 0.5, "to_slope": -1},
    {"kind": "sine", "x0": 0, "x1": 64, "middle": 30, "amplitude": 8, "wavelength": 64, "origin": 0},
    {"kind": "polyline", "x0": 0, "x1": 8, "ys": [1, 2, 0.5], "colour": "red"}
  ],)"));
  EXPECT_THAT(text, HasSubstr(R"({"name": "hero", "kind": "player", "x": 8, "y": 8, "vx": 0, "vy": 0, )"
                              R"("size": [6, 12.5], "foot": "box"})"));
  EXPECT_THAT(text, HasSubstr(R"("ball": 1, "one_way": 7})"));
  EXPECT_THAT(text, HasSubstr(R"("solver": "exact",)"));
  EXPECT_THAT(text, HasSubstr(R"("exact": {"gravity": 0, "steepest": 2, )"));
  EXPECT_THAT(text, HasSubstr(R"("single_precision": 0, "substeps": 4})"));
  EXPECT_THAT(text, Not(HasSubstr("\"player\": {")));
}

TEST(NativeShapes, AreReadAsWritten) {
  const Level level = level_with_everything();
  const std::string text = native_of_level(level);
  EXPECT_EQ(level_of_native(text), level);
  EXPECT_EQ(native_of_level(level_of_native(text)), text);
}

TEST(NativeShapes, ConveyorsAreReadAsWritten) {
  Level level;
  level.tile_shapes[2] = {.kind = TileShape::Kind::solid, .conveyor = -0.75};
  level.tile_shapes[3] = {.kind = TileShape::Kind::group,
                          .parts = {{.kind = TileShape::Kind::solid}, {.kind = TileShape::Kind::solid}},
                          .conveyor = 2};
  level.curves = {{"", {Segment{{0, 10}, {50, 20}}, Curve::Faces::up, 1.5}, ""}};
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, HasSubstr(R"("2": {"kind": "solid", "conveyor": -0.75})"));
  EXPECT_EQ(level_of_native(text), level);
  expect_error(R"("tile_shapes": {"5": {"kind": "solid", "conveyor": 65}})", "key tile_shapes.5",
               "has a conveyor that is faster than 64 px a frame");
  expect_error(R"("tile_shapes": {"5": {"kind": "solid", "conveyor": "1"}})", "key tile_shapes.5.conveyor",
               "must be a number");
}

TEST(NativeShapes, AConveyorTakesTheShapeOfTheFlags) {
  const std::string flags = R"("roles": {"solid": 0}, "tiles": {"5": {"flags": [0]}}, )";
  const std::string conveyor = R"("tile_shapes": {"5": {"conveyor": 1.5}})";
  const auto level = level_of_native(native_with(flags + conveyor));
  EXPECT_EQ(level.tile_shapes[5], (TileShape{.kind = TileShape::Kind::solid, .conveyor = 1.5}));
  expect_error(conveyor, "key tile_shapes.5",
               "has a conveyor, but neither a \"kind\" nor flags that give it a shape");
  expect_error(R"("flag_shapes": {"5": {"conveyor": 1}})", "key flag_shapes.5",
               "has a conveyor, but no \"kind\"");
}

Level level_with_polygons() {
  Level level;
  TileShape polygon;
  polygon.kind = TileShape::Kind::polygon;
  polygon.one_way = true;
  polygon.points = {{-8, 0}, {8, 2.5}, {0, 8}};
  TileShape group;
  group.kind = TileShape::Kind::group;
  group.parts = {
      polygon, {.kind = TileShape::Kind::slope, .heights = {0, 8}}, {.kind = TileShape::Kind::solid}};
  level.tile_shapes[3] = polygon;
  level.tile_shapes[4] = group;
  return level;
}

TEST(NativeShapes, PolygonsAreReadAsWritten) {
  const Level level = level_with_polygons();
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, HasSubstr(R"("talus": 3,)"));
  EXPECT_THAT(text, HasSubstr("[-8, 0],\n        [8, 2.5],\n"));
  EXPECT_EQ(level_of_native(text), level);
  EXPECT_EQ(native_of_level(level_of_native(text)), text);
}

TEST(NativeShapes, OnlyPolygonsNeedVersionThree) {
  EXPECT_THAT(native_of_level(level_with_everything()), HasSubstr(R"("talus": 1,)"));
  Level level = level_with_polygons();
  level.tile_shapes[3] = level.tile_shapes[4] = {};
  level.flag_shapes[2] = level_with_polygons().tile_shapes[4];
  EXPECT_THAT(native_of_level(level), HasSubstr(R"("talus": 3,)"));
}

TEST(NativeShapes, ErrorsOfPolygonsHaveTheirPlace) {
  const auto with = [](const std::string& shape) { return R"("tile_shapes": {"5": )" + shape + "}"; };
  expect_error(with(R"({"kind": "polygon", "points": [[0, 0], [8, 8]]})"), "key tile_shapes.5",
               "needs at least 3 points");
  expect_error(with(R"({"kind": "polygon", "points": [[0, 0], [8], [0, 8]]})"), "key tile_shapes.5.points",
               "must be a list of points [x, y]");
  expect_error(with(R"({"kind": "group", "parts": 7})"), "key tile_shapes.5.parts",
               "must be a list of up to 64 shapes");
  expect_error(with(R"({"kind": "group", "parts": [{"kind": "group", "parts": []}]})"),
               "key tile_shapes.5.parts[0]", "has the key \"parts\", which no part has");
  expect_error(with(R"({"kind": "group", "parts": [{"kind": "solid"}, {"kind": "ramp"}]})"),
               "key tile_shapes.5.parts[1].kind",
               R"(must be "none", "solid", "slope", "profile", "polygon" or "group")");
}

TEST(NativeShapes, TheFuzzersSeedIsReadable) {
  const Level level = load_level(source_path("tests/fuzz/seeds/shapes.talus.json"))->level;
  EXPECT_EQ(level.curves.size(), 7u);
  EXPECT_EQ(level_of_native(native_of_level(level)), level);
}

TEST(NativeShapes, DefaultsAreLeftOut) {
  const std::string text = native_of_level(Level());
  for (const char* key : {"tile_shapes", "flag_shapes", "curves", "one_way", "ceiling", "exact", "player"})
    EXPECT_THAT(text, Not(HasSubstr("\"" + std::string(key) + "\":"))) << key;
}

TEST(NativeShapes, UnknownKeysAreKept) {
  const std::string text =
      native_with(R"("tile_shapes": {"7": {"kind": "solid", "sound": 3}, "9": {"later": 1}},
      "curves": [{"kind": "segment", "from": [0, 0], "to": [8, 8], "radius": 5}],
      "tuning": {"exact": {"wind": 2}})");
  const Level level = level_of_native(text);
  EXPECT_EQ(level.curves.at(0).extra, R"({"radius":5})");
  const std::string written = native_of_level(level);
  EXPECT_THAT(written, HasSubstr(R"("7": {"kind": "solid", "sound": 3})"));
  EXPECT_THAT(written, HasSubstr(R"("9": {"later": 1})"));
  EXPECT_THAT(written, HasSubstr(R"("exact": {"wind": 2})"));
  EXPECT_THAT(written, HasSubstr(R"("to": [8, 8], "radius": 5})"));
  EXPECT_EQ(native_of_level(level_of_native(written)), written);
}

TEST(NativeShapes, ShapeErrorsSayWhere) {
  const auto expect = [](const std::string& shape, const std::string& place, const std::string& message) {
    expect_error(R"("tile_shapes": {"12": )" + shape + "}", "key tile_shapes.12" + place, message);
  };
  expect("7", "", "must be an object");
  expect(R"({"kind": "cube"})", ".kind",
         R"(must be "none", "solid", "slope", "profile", "polygon" or "group")");
  expect(R"({"side": 1})", ".side", R"(must be "floor" or "ceiling")");
  expect(R"({"one_way": 1})", ".one_way", "must be true or false");
  expect(R"({"tiles": 1.5})", ".tiles", "must be a whole number");
  expect(R"({"tiles": 9})", "", "must be 1 to 8 tiles wide");
  expect(R"({"heights": [1, "2"]})", ".heights", "must be a list of numbers");
  expect(R"({"kind": "slope", "heights": [1]})", "", "must have 2 heights");
  expect(R"({"kind": "slope", "heights": [0, 65]})", "", "has a height that is not from 0 to 64 px");
  expect_error(R"("tile_shapes": {"256": {}})", "key tile_shapes.256", "must be a tile number from 0 to 255");
  expect_error(R"("flag_shapes": {"32": {}})", "key flag_shapes.32", "must be a flag from 0 to 31");
  expect_error(R"("flag_shapes": {"07": {}})", "key flag_shapes.07", "must be a flag from 0 to 31");
  expect_error(R"("flag_shapes": {"1": {"kind": "profile"}})", "key flag_shapes.1",
               "must have 3 to 65 heights");
}

TEST(NativeShapes, CurveErrorsSayWhere) {
  const auto expect = [](const std::string& curve, const std::string& place, const std::string& message) {
    expect_error(R"("curves": [{"kind": "segment", "from": [0, 0], "to": [1, 1]}, )" + curve + "]",
                 "key curves[1]" + place, message);
  };
  expect_error(R"("curves": {})", "key curves", "must be a list of up to 16384 curves");
  expect("7", "", "must be an object");
  expect("{}", ".kind", R"(must be "segment", "arc", "parabola", "cubic", "sine" or "polyline")");
  expect(R"({"kind": "arc", "center": [1, 2, 3]})", ".center", "must be a point [x, y]");
  expect(R"({"kind": "arc", "center": [1, 2]})", ".radius", "is missing");
  expect(R"({"kind": "arc", "center": [1, 2], "radius": "1"})", ".radius", "must be a number");
  expect(R"({"kind": "arc", "center": [9, 9], "radius": 1, "x0": 8, "x1": 11})", "",
         "has an end beyond its circle");
  expect(R"({"kind": "polyline", "x0": 1, "x1": 1, "ys": [1, 2]})", "", "has a width of zero");
  expect(R"({"kind": "segment", "from": [0, 0], "to": [1921, 1]})", "", "has its last end off the map");
  expect(R"({"kind": "segment", "name": 5})", ".name", "must be a string");
  expect(R"({"kind": "segment", "faces": "left"})", ".faces", R"(must be "up", "down" or "both")");
}

TEST(NativeShapes, NumbersTooLargeForADoubleSayWhere) {
  const std::string why = "has a number that is too large";
  expect_error(
      "\n\"curves\": [{\"kind\": \"segment\", \"from\": [0, 0], \"to\": [1, 1]},\n"
      "{\"kind\": \"arc\", \"center\": [1, -1e400]}]",
      "line 3, key curves[1].center[1]", why);
  expect_error(R"("tile_shapes": {"7": {"kind": "solid"}, "8": {"tiles": 1e400}})",
               "line 1, key tile_shapes.8.tiles", why);
  expect_error("\n\n\"a\": [],\n  \"b\": NaN", "line 4, column 8", "this is not valid JSON");
  EXPECT_EQ(read_native("1e400", {}).error().place, "line 1");
}

TEST(NativeShapes, TheMapMayFollowItsCurvesInTheFile) {
  const std::string curve = R"("curves": [{"kind": "segment", "from": [0, 0], "to": [2400, 1]}])";
  EXPECT_EQ(level_of_native(native_with(curve + R"(, "map": {"width": 300})")).curves.size(), 1u);
}

TEST(NativeShapes, SpawnAndTuningErrorsSayWhere) {
  expect_error(R"("spawns": [{"kind": "coin"}])", "key spawns[0].kind",
               R"(must be "ball", "player", "crate", "disc" or "marble")");
  expect_error(R"("spawns": [{"foot": null}])", "key spawns[0].foot", R"(must be "box" or "centre")");
  expect_error(R"("spawns": [{"size": [8, 0]}])", "key spawns[0].size",
               "must be [width, height], each from 0.00390625 to 1024 px");
  expect_error(R"("tuning": {"exact": {"substeps": 1.5}})", "key tuning.exact.substeps",
               "must be a whole number from 1 to 64");
  expect_error(R"("tuning": {"player": {"jump_cut": 2}})", "key tuning.player.jump_cut",
               "must be a number from 0 to 1");
  expect_error(R"("tuning": {"player": 2})", "key tuning.player", "must be an object");
  expect_error(R"("roles": {"one_way": 32})", "key roles.one_way", "must be a flag from 0 to 31, or null");
}

TEST(NativeShapes, LevelsThatCannotBeReadAreNotWritten) {
  const auto error_of = [](const Level& level) { return write_native(level, {}).error(); };
  Level level;
  level.tile_shapes[3] = {.kind = TileShape::Kind::slope,
                          .heights = {0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_EQ(error_of(level).place, "key tile_shapes.3");
  EXPECT_EQ(error_of(level).message, "has a height that is not a number");
  level.tile_shapes[3] = {};
  level.curves.push_back({"", {Segment{{0, 0}, {5000, 1}}, Curve::Faces::up}, ""});
  EXPECT_EQ(error_of(level).place, "key curves[0]");
  EXPECT_EQ(error_of(level).message, "has its last end off the map");
  level.curves.clear();
  level.spawns = {{"", {}, {}, "", BodyKind::ball, {0, 8}}};
  EXPECT_EQ(error_of(level).place, "key spawns[0].size");
  level.spawns.clear();
  level.tuning.exact.max_passes = 4.5;
  EXPECT_EQ(error_of(level).place, "key tuning.exact.max_passes");
}

}  // namespace talus::native_shapes_test
