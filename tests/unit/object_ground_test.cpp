// Objects of a map as ground: cut into cells, and compiled with the tiles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <talus/collision/shape_forms.h>
#include <talus/formats/format.h>
#include <talus/level/ground.h>
#include <talus/sim/scene.h>
#include <talus/sim/solver.h>
#include "level/lint/lint.h"
#include "level/local_ground.h"
#include "level/object_cells.h"
#include "level/object_ground.h"

namespace talus {
namespace {

using Points = std::vector<Vec2>;

bool is_inside(const Points& outline, Vec2 place) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.y <= place.y) == (b.y <= place.y)) continue;
    if (place.x < a.x + (b.x - a.x) * ((place.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

double distance_to(const Points& outline, Vec2 place) {
  double least = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], side = outline[(i + 1) % outline.size()] - a;
    const double length = dot(side, side);
    const double along = length == 0 ? 0 : std::clamp(dot(place - a, side) / length, 0.0, 1.0);
    const Vec2 off = place - (a + side * along);
    least = std::min(least, std::hypot(off.x, off.y));
  }
  return least;
}

// Whether a level without tiles has ground at a place.
bool is_ground_at(const Level& tiles, Vec2 place) {
  const TileSize size = tiles.map.tile_size();
  const Cell cell{static_cast<int>(place.x / size.width), static_cast<int>(place.y / size.height)};
  const auto at = static_cast<std::size_t>(cell.y * tiles.map.width() + cell.x);
  const auto& cells = tiles.layers.list.back().cells->tiles();
  const TileShape& shape = tiles.tile_shapes[static_cast<std::size_t>(cells[at])];
  return shape.kind != TileShape::Kind::none && is_in_ground(shape, size, place - tiles.map.corner_of(cell));
}

Level level_with(std::vector<MapObject> objects, TileSize tile = {16, 16}) {
  Level level;
  level.map = TileMap(20, 15, tile);
  level.tuning.solver = SolverKind::exact;
  level.objects = {{.name = "walls", .is_ground = true, .objects = std::move(objects)}};
  return level;
}

MapObject box_object(Rect box, double rotation = 0) {
  return {.position = {box.x, box.y}, .size = {box.w, box.h}, .rotation = rotation};
}

MapObject polygon_object(Points points) {
  return {.form = MapObject::Form::polygon, .points = std::move(points)};
}

void expect_same_area(const Level& level, const Points& outline) {
  const Level tiles = with_object_tiles(level);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, level.map.px_width()), y(0, level.map.px_height());
  for (int i = 0; i < 3000; ++i) {
    const Vec2 place{x(random), y(random)};
    if (distance_to(outline, place) < 1.0 / 128) continue;
    ASSERT_EQ(is_ground_at(tiles, place), is_inside(outline, place)) << place.x << ", " << place.y;
  }
}

TEST(ObjectGround, HasTheAreaOfItsObjects) {
  for (const TileSize tile : {TileSize{8, 8}, {16, 16}, {18, 12}, {24, 24}, {32, 32}}) {
    for (const MapObject& object :
         {box_object({20, 30, 100, 40}), box_object({70.5, 20.25, 60, 33}, 31),
          MapObject{.form = MapObject::Form::ellipse, .position = {12, 9}, .size = {95, 61}, .rotation = 12},
          polygon_object({{10, 10}, {90, 15}, {40, 40}, {95, 80}, {12, 70}, {30, 45}}),
          polygon_object({{-50, 20}, {500, 60}, {60, 300}}),
          polygon_object(
              {{10, 10}, {100, 10}, {100, 100}, {90, 100}, {90, 20}, {20, 20}, {20, 100}, {10, 100}}),
          polygon_object({{10, 10}, {90, 90}, {90, 10}, {10, 90}}),
          polygon_object({{16, 0}, {17, 200}, {15, 200}})}) {
      const Level level = level_with({object}, tile);
      EXPECT_EQ(ground_problem(level), std::nullopt);
      expect_same_area(level, outline_of(object));
    }
  }
}

TEST(ObjectGround, RandomPolygonsHaveTheirArea) {
  std::mt19937 random(99);
  std::uniform_int_distribution<int> corners(3, 9);
  std::uniform_real_distribution<double> at(-20, 150);
  for (int round = 0; round < 40; ++round) {
    Points points;
    for (int i = corners(random); i > 0; --i) points.push_back({at(random), at(random)});
    const Level level = level_with({polygon_object(points)}, {round % 3 * 7 + 8, round % 4 * 5 + 8});
    SCOPED_TRACE(round);
    expect_same_area(level, points);
  }
}

// A floor of two objects and a tile between them, as one line:
//
//   |  slope object /tile\ box object |
TEST(ObjectGround, HasNoSeams) {
  Level level = level_with({box_object({0, 100, 160, 60}), box_object({160, 100, 160, 60})});
  const Terrain terrain = terrain_of(level);
  for (int x = 1; x < 20; ++x) {
    for (const Piece<double>& piece : terrain.pieces_in({x, 6})) {
      if (piece.facing != Facing::up) continue;
      EXPECT_EQ(piece.y0, 100);
      EXPECT_EQ(piece.y1, 100);
    }
    for (const Piece<double>& piece : terrain.pieces_in({x, 7}))
      EXPECT_FALSE(piece.is_wall() && piece.x0 < 320) << "inside of the ground at " << piece.x0;
  }
}

TEST(ObjectGround, ASideIsOneLineInAllItsCells) {
  const Vec2 left{13, 150}, right{283, 75};  // 5 px up in 18
  MapObject area;
  area.form = MapObject::Form::polygon;
  area.points = {left, right, {283, 200}, {13, 200}};
  const Terrain terrain = terrain_of(level_with({area}));
  int pieces = 0;
  for (Cell cell; cell.y < 15; ++cell.y) {
    for (cell.x = 0; cell.x < 20; ++cell.x) {
      for (const Piece<double>& piece : terrain.pieces_in(cell)) {
        if (piece.facing != Facing::up) continue;
        ++pieces;
        EXPECT_EQ(piece.slope, -75.0 / 270);
        for (const Vec2 end : {Vec2{piece.x0, piece.y0}, Vec2{piece.x1, piece.y1}})
          EXPECT_NEAR(end.y, 150 - (end.x - 13) * 75 / 270, 1e-11);
      }
    }
  }
  EXPECT_GE(pieces, 17);
}

TEST(ObjectGround, ABodyStandsAndWalksOnIt) {
  Level level = level_with({box_object({0, 120, 110.5, 60}),
                            polygon_object({{110.5, 120}, {200, 90.3}, {200, 180}, {110.5, 180}})});
  Spawn spawn;
  spawn.position = {60, 100};
  spawn.velocity = {1, 0};
  level.spawns = {spawn};
  const Scene scene = compile_scene(level);
  ASSERT_NE(scene.ground, nullptr);
  const auto box = std::find_if(scene.items.begin(), scene.items.end(),
                                [](const SceneItem& item) { return item.role == TileRole::ball; });
  EXPECT_NE(box, scene.items.end());
  EXPECT_GT(scene.ground_lines, 0u);
  EXPECT_EQ(ground_problem(level), std::nullopt);
  level.objects.front().is_ground = false;
  EXPECT_EQ(compile_scene(level).ground_lines, 0u);
}

TEST(ObjectGround, PaintedCellsKeepIt) {
  Level level = level_with({polygon_object({{0, 100}, {320, 130}, {320, 240}, {0, 240}})});
  level.tile_shapes[5].kind = TileShape::Kind::solid;
  const Scene before = compile_scene(level);
  level.map.set({3, 6}, 5);
  const Cell changed[] = {{3, 6}};
  EXPECT_EQ(recompile_scene(before, level, changed), compile_scene(level));
}

TEST(ObjectGround, PolylinesAndOneWaySidesAreLines) {
  MapObject line{.form = MapObject::Form::polyline, .points = {{10, 20}, {50, 30}, {50, 60}}};
  MapObject cloud = box_object({100, 50, 40, 10});
  cloud.one_way = true;
  const Level tiles = with_object_tiles(level_with({line, cloud}));
  ASSERT_EQ(tiles.curves.size(), 3u);
  EXPECT_EQ(tiles.curves[0].curve, (Curve{Segment{{10, 20}, {50, 30}}, Curve::Faces::both}));
  EXPECT_EQ(tiles.curves[1].curve, (Curve{Segment{{50, 30}, {50, 60}}, Curve::Faces::both}));
  EXPECT_EQ(tiles.curves[2].curve, (Curve{Segment{{100, 50}, {140, 50}}, Curve::Faces::up}));
  EXPECT_FALSE(is_ground_at(tiles, {110, 55}));
}

TEST(ObjectGround, SaysWhatIsTooMuch) {
  Points points;
  for (int i = 0; i < 2000; ++i) points.push_back({100 + 90 * std::cos(i * 0.00314), 100 + i % 7 * 1.0});
  EXPECT_THAT(ground_problem(level_with({polygon_object(points)})),
              testing::Optional(testing::HasSubstr("more than 1024 points")));
}

TEST(ObjectGround, PointsOnALineAreNoCorners) {
  Points points;  // two sides of a square, each in many steps, and a way back into a corner
  for (int i = 0; i < 1500; ++i) points.push_back({32 + 64 * (i / 1500.0), 32});
  for (int i = 0; i < 1500; ++i) points.push_back({96, 32 + 64 * (i / 1500.0)});
  points.insert(points.end(), {{96, 96}, {96, 100}, {96, 96}, {32, 96}, {32, 64}});
  expect_same_area(level_with({polygon_object(points)}), {{32, 32}, {96, 32}, {96, 96}, {32, 96}});
}

TEST(ObjectGround, IsTheSameAroundABox) {
  const Level level = level_with({polygon_object({{0, 100}, {320, 131}, {320, 240}, {0, 240}})});
  const LocalGround local = ground_around(level, {200, 90, 8, 8}, 16);
  const Terrain whole = terrain_of(level);
  const Cell cell{13, 7};
  const TileSize size = level.map.tile_size();
  const Cell there{cell.x - static_cast<int>(local.corner.x) / size.width,
                   cell.y - static_cast<int>(local.corner.y) / size.height};
  EXPECT_EQ(whole.shape_at(cell), local.terrain.shape_at(there));
}

const char* const kObjectMap = R"({"type":"map","orientation":"orthogonal","width":20,"height":15,
"tilewidth":16,"tileheight":16,"tilesets":[],"layers":[
{"type":"tilelayer","name":"back","width":20,"height":15,"data":[)";

std::string object_map(const std::string& layer) {
  std::string text = kObjectMap;
  for (int i = 0; i < 300; ++i) text += i == 0 ? "0" : ",0";
  return text + "]}," + layer + "]}";
}

LoadedLevel load_object_map(const std::string& layer) {
  FormatContext context;
  context.extension = "tmj";
  auto loaded = read_level(object_map(layer), context);
  EXPECT_TRUE(loaded) << loaded.error().message;
  return loaded ? *std::move(loaded) : LoadedLevel();
}

TEST(ObjectGround, LayersOfTiledAreGroundByTheirName) {
  const auto is_ground = [](const std::string& head) {
    const LoadedLevel loaded =
        load_object_map("{\"type\":\"objectgroup\"," + head +
                        ",\"objects\":[{\"x\":16,\"y\":32,\"width\":64,\"height\":20}]}");
    return loaded.level.objects.size() == 1 && loaded.level.objects[0].is_ground;
  };
  EXPECT_TRUE(is_ground(R"("name":"Collision")"));
  EXPECT_TRUE(is_ground(R"("name":"level","class":"walls")"));
  EXPECT_TRUE(is_ground(R"("name":"a","properties":[{"name":"solid","type":"bool","value":true}])"));
  EXPECT_FALSE(is_ground(R"("name":"Walls","properties":[{"name":"solid","type":"bool","value":false}])"));
  EXPECT_FALSE(is_ground(R"("name":"doors")"));
}

TEST(ObjectGround, MovesWithTheOffsetOfItsLayer) {
  Level moved = level_with({box_object({20, 30, 50, 40}, 10)});
  moved.objects[0].offset = {5.5, -7};
  const Level there = level_with({box_object({25.5, 23, 50, 40}, 10)});
  EXPECT_EQ(with_object_tiles(moved), with_object_tiles(there));
}

TEST(ObjectGround, ObjectsOfTiledAreKeptWithAllTheyHave) {
  const LoadedLevel loaded = load_object_map(
      R"({"type":"objectgroup","name":"solid","offsetx":4,"objects":[
      {"x":16,"y":32,"width":64,"height":20,"rotation":5,"name":"rock","type":"stone",
       "properties":[{"name":"hp","type":"int","value":3},{"name":"one_way","type":"bool","value":true}]},
      {"x":0,"y":0,"polygon":[{"x":0,"y":0},{"x":9,"y":0},{"x":0,"y":9}]},
      {"x":8,"y":8,"width":8,"height":8,"type":"ball"}]})");
  ASSERT_EQ(loaded.level.objects.size(), 1u);
  ASSERT_EQ(loaded.level.objects[0].objects.size(), 2u) << "the ball is a body";
  const MapObject& rock = loaded.level.objects[0].objects[0];
  EXPECT_EQ(rock.name, "rock");
  EXPECT_EQ(rock.type, "stone");
  EXPECT_EQ(rock.position, (Vec2{16, 32}));
  EXPECT_EQ(loaded.level.objects[0].offset, (Vec2{4, 0}));
  EXPECT_EQ(rock.rotation, 5);
  EXPECT_TRUE(rock.one_way);
  EXPECT_EQ(rock.properties, R"({"hp":3,"one_way":true})");
  EXPECT_EQ(loaded.level.objects[0].objects[1].points.size(), 3u);
  FormatContext native;
  native.extension = "json";
  const auto text = find_format("native")->write(loaded.level, native);
  ASSERT_TRUE(text) << text.error().message;
  const auto again = read_level(text->bytes, native);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->level.objects, loaded.level.objects);
}

// All of its ground would be gone, and nothing would say so.
TEST(ObjectGround, OutlinesThatAreTooLargeAreAProblem) {
  MapObject star;
  star.form = MapObject::Form::polygon;
  for (int i = 0; i < 2000; ++i) {
    const double angle = std::numbers::pi * i / 1000, radius = i % 2 == 0 ? 90 : 80;
    star.points.push_back({160 + radius * std::cos(angle), 120 + radius * std::sin(angle)});
  }
  const Level level = level_with({star});
  const auto problems = lint(level);
  const auto found = std::find_if(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.rule->code == "too-much-ground";
  });
  ASSERT_NE(found, problems.end());
  EXPECT_EQ(found->message, "the level " + *ground_problem(level));
}

}  // namespace
}  // namespace talus
