// Turned tiles: their shapes, and levels that have them.
#include <gmock/gmock.h>

#include <talus/collision/shape_forms.h>
#include <talus/level/ground.h>
#include <talus/level/tile_turns.h>
#include <talus/sim/scene.h>
#include "collision/ground_queries.h"
#include "formats/native/native.h"
#include "level/ground_cells.h"
#include "level/ground_level.h"
#include "level/level_version.h"
#include "level/lint/lint.h"
#include "level/transform.h"

namespace talus::tile_turns_test {

using Kind = TileShape::Kind;
using Side = TileShape::Side;
using testing::ElementsAre;

constexpr TileSize kSquare{8, 8};
constexpr TileTurn kHalf = turn_of(false, true, true);

std::vector<TileTurn> all_turns() {
  std::vector<TileTurn> turns;
  for (int turn = 0; turn < kTileTurns; ++turn) turns.push_back(static_cast<TileTurn>(turn));
  return turns;
}

TileShape slope(double left, double right) { return {.kind = Kind::slope, .heights = {left, right}}; }
TileShape polygon(std::vector<Vec2> points) {
  TileShape shape{.kind = Kind::polygon};
  shape.points = std::move(points);
  return shape;
}

// Where Tiled draws a place of a tile, by its rules: the diagonal flip first, then the others.
Vec2 as_in_tiled(Vec2 p, TileTurn turn, TileSize tile) {
  if (has_flip(turn, TileTurn::diagonal)) p = {p.y, p.x};
  const TileSize size = turned(tile, turn);
  if (has_flip(turn, TileTurn::left_right)) p.x = size.width - p.x;
  if (has_flip(turn, TileTurn::up_down)) p.y = size.height - p.y;
  p.y += tile.height - size.height;
  return p;
}

// The ground that a shape makes is turned in each of the eight turns.
void expect_turned_ground(const TileShape& shape, TileSize tile) {
  ASSERT_EQ(problem_of(shape, tile), std::nullopt);
  for (const TileTurn turn : all_turns()) {
    const TileShape image = turned(shape, turn, tile);
    ASSERT_EQ(problem_of(image, tile), std::nullopt) << static_cast<int>(turn);
    for (double y = -3.9371; y < tile.height + 4; y += 0.6127) {  // no point is on a side
      for (double x = -3.9371; x < tile.width + 4; x += 0.6137) {
        EXPECT_EQ(is_in_ground(image, tile, as_in_tiled({x, y}, turn, tile)),
                  is_in_ground(shape, tile, {x, y}))
            << "turn " << static_cast<int>(turn) << " at " << x << ", " << y;
      }
    }
  }
}

TEST(TileTurns, FollowOneAnother) {
  EXPECT_EQ(after_turn(kTurnRight, kTurnRight), kHalf);
  EXPECT_EQ(after_turn(kHalf, kTurnRight), kTurnLeft);
  EXPECT_EQ(after_turn(kTurnRight, kTurnLeft), TileTurn::none);
  for (const TileTurn first : all_turns()) {
    for (const TileTurn next : all_turns()) {
      const Vec2 place{1, 3};
      EXPECT_EQ(as_in_tiled(as_in_tiled(place, first, kSquare), next, kSquare),
                as_in_tiled(place, after_turn(first, next), kSquare));
    }
  }
}

TEST(TileTurns, PixelsAreThoseOfTheTile) {
  constexpr TileSize kWide{6, 4};
  for (const TileTurn turn : all_turns()) {
    const TileSize size = turned(kWide, turn);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Cell from = pixel_before_turn({x, y}, turn, kWide);
        const Vec2 middle = as_in_tiled({from.x + 0.5, from.y + 0.5}, turn, kWide);
        EXPECT_EQ(middle, (Vec2{x + 0.5, y + 0.5 + top_of_turned(kWide, turn)}));
      }
    }
  }
}

TEST(TileTurns, MirroredSlopesAndProfilesStayWhatTheyAre) {
  const TileShape profile{.kind = Kind::profile, .heights = {0, 3, 8}};
  EXPECT_EQ(turned(slope(0, 8), TileTurn::left_right, kSquare), slope(8, 0));
  EXPECT_EQ(turned(profile, TileTurn::left_right, kSquare).heights, (std::vector<double>{8, 3, 0}));
  const TileShape ceiling = turned(profile, kHalf, kSquare);
  EXPECT_EQ(ceiling.side, Side::ceiling);
  EXPECT_EQ(ceiling.heights, (std::vector<double>{8, 3, 0}));
}

TEST(TileTurns, AQuarterTurnOfASlopeIsAPolygon) {
  const TileShape right = turned(slope(2, 8), kTurnRight, kSquare);
  EXPECT_EQ(right.kind, Kind::polygon);
  EXPECT_THAT(right.points, ElementsAre(Vec2{0, 0}, Vec2{2, 0}, Vec2{8, 8}, Vec2{0, 8}));
}

TEST(TileTurns, GroundTurnsWithThePicture) {
  for (const TileSize tile : {kSquare, TileSize{8, 6}, TileSize{6, 8}}) {
    expect_turned_ground(slope(1, 5), tile);
    expect_turned_ground({.kind = Kind::solid}, tile);
    expect_turned_ground({.kind = Kind::slope, .side = Side::ceiling, .heights = {0, 4}}, tile);
    expect_turned_ground({.kind = Kind::slope, .tiles = 2, .heights = {0, 6}}, tile);
    expect_turned_ground({.kind = Kind::profile, .heights = {0, 4, 0, 0, 2}}, tile);
    expect_turned_ground(polygon({{1, 1}, {5, 0}, {4, 6}, {3, 2}}), tile);
    expect_turned_ground({.kind = Kind::group,
                          .parts = {slope(0, 3), polygon({{0, 0}, {4, 0}, {0, 3}}), {.kind = Kind::solid}}},
                         tile);
  }
}

TEST(TileTurns, OneWayGroundStopsFromTheTurnedSide) {
  const TileShape plank{.kind = Kind::solid, .one_way = true};
  EXPECT_EQ(turned(plank, TileTurn::left_right, kSquare), plank);
  const TileShape below = turned(plank, TileTurn::up_down, kSquare);
  EXPECT_EQ(below.side, Side::ceiling);
  EXPECT_EQ(below.points.size(), 4U);
  EXPECT_TRUE(below.one_way);
  TileShape ramp = slope(0, 8);
  ramp.one_way = true;
  EXPECT_EQ(turned(ramp, kHalf, kSquare),
            (TileShape{.kind = Kind::slope, .side = Side::ceiling, .one_way = true, .heights = {8, 0}}));
  for (const auto& [turn, side] : {std::pair(kTurnLeft, Side::left), {kTurnRight, Side::right}}) {
    EXPECT_EQ(turned(plank, turn, kSquare).side, side);
    EXPECT_EQ(turned(ramp, turn, kSquare).side, side);
  }
  EXPECT_EQ(problem_of(turned(ramp, kTurnLeft, kSquare), kSquare),
            "stops bodies on its left side alone, which no solver can");
}

constexpr TileNumber kFull = 1, kRise = 2, kBall = 3, kPlank = 4;

Level level_of(std::vector<MapCell> cells) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(static_cast<int>(cells.size()), 2);
  level.tile_shapes[kFull] = {.kind = Kind::solid};
  level.tile_shapes[kRise] = slope(0, 8);
  level.tile_shapes[kPlank] = {.kind = Kind::solid, .one_way = true};
  level.sheet(SheetId::tiles).flags[kBall] = static_cast<std::uint8_t>(1 << level.roles.ball);
  for (std::size_t x = 0; x < cells.size(); ++x) level.map.set({static_cast<int>(x), 1}, cells[x]);
  return level;
}

TEST(TurnedTiles, TakeNoMemoryUntilThereAreSome) {
  MapCells cells(3);
  EXPECT_TRUE(cells.turns().empty());
  cells.set(1, {kRise, kTurnLeft});
  EXPECT_EQ(cells[1], MapCell(kRise, kTurnLeft));
  EXPECT_EQ(cells[2], MapCell());
  cells.set(1, kRise);
  EXPECT_TRUE(cells.turns().empty());
  EXPECT_EQ(cells, MapCells(std::vector<TileNumber>{0, kRise, 0}));
}

TEST(TurnedTiles, HaveGroundOfTheirOwn) {
  const Level level = level_of({{kRise, TileTurn::left_right}, {kFull, kTurnRight}, {kBall, kHalf}});
  const GroundCells ground = ground_cells(level);
  EXPECT_EQ(ground.stacks, (std::vector<TileStack>{{{kRise, TileTurn::left_right}}}));
  EXPECT_THAT(std::vector(ground.cells.begin() + 3, ground.cells.end()), ElementsAre(256, kFull, kBall))
      << "a turn that changes nothing needs no number";
  const Terrain terrain = terrain_of(level);
  EXPECT_TRUE(overlaps_ground(terrain, Rect{1, 10, 1, 1}));
  EXPECT_FALSE(overlaps_ground(terrain, Rect{6, 10, 1, 1}));
}

TEST(TurnedTiles, AreGroundForAllSolvers) {
  Level level = level_of({{kRise, TileTurn::left_right}, {kBall, kTurnRight}});
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    level.tuning.solver = solver;
    const Scene scene = compile_scene(level);
    ASSERT_EQ(scene.items.size(), 2U);
    EXPECT_EQ(scene.items[0].role, TileRole::down_slope);
    EXPECT_EQ(scene.items[1].role, TileRole::ball);
  }
}

TEST(TurnedTiles, RecompiledAreAsCompiled) {
  const Level level = level_of({{kRise, TileTurn::left_right}, kRise, kFull, 0});
  const Scene scene = compile_scene(level);
  for (const TileTurn turn : all_turns()) {
    Level edited = level;
    edited.map.set({3, 1}, {kRise, turn});
    const std::vector<Cell> cells{{3, 1}};
    EXPECT_EQ(recompile_scene(scene, edited, cells), compile_scene(edited)) << static_cast<int>(turn);
  }
}

TEST(TurnedTiles, OneWayToASideIsAProblem) {
  const Level level = level_of({{kPlank, kTurnRight}});
  const std::vector<Problem> problems = lint(level);
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.message.find("stops bodies on its right side alone") != std::string::npos;
  }));
  EXPECT_FALSE(overlaps_ground(terrain_of(level), Rect{1, 9, 6, 6}));
}

TEST(TurnedTiles, AreKeptInNativeLevels) {
  Level level = level_of({{kRise, TileTurn::left_right}, kRise, {kFull, kTurnRight}});
  level.brushes.push_back({.name = "b", .w = 2, .tiles = {kRise, {kFull, kHalf}}, .extra = ""});
  const auto written = write_native(level, {});
  ASSERT_TRUE(written);
  EXPECT_THAT(written->bytes, testing::HasSubstr("\"talus\": 6"));
  const auto read = read_native(written->bytes, {});
  ASSERT_TRUE(read) << read.error().place << ": " << read.error().message;
  EXPECT_EQ(*read, level);
  Level layered = level;
  layered.layers.list.push_back(
      {.name = "more", .cells = std::make_shared<const MapCells>(level.map.cells())});
  EXPECT_EQ(read_native(write_native(layered, {})->bytes, {}).value(), layered);
}

TEST(TurnedTiles, LargeLayersOfThemArePacked) {
  Level level;
  level.map = TileMap(2048, 513);
  level.map.set({2047, 512}, {1, kTurnLeft});
  level.layers.list.front().name = "large";
  const auto written = write_native(level, {});
  ASSERT_TRUE(written);
  EXPECT_THAT(written->bytes, testing::HasSubstr("\"packed_turns\""));
  EXPECT_EQ(read_native(written->bytes, {}).value(), level);
}

TEST(TurnedTiles, FaultyTurnsAreRefusedWithTheirPlace) {
  const auto error = [](const std::string& members) {
    const auto read =
        read_native("{\"talus\": 6, \"map\": {\"width\": 2, \"height\": 1, " + members + "}}", {});
    return read ? "" : read.error().place + ": " + read.error().message;
  };
  EXPECT_EQ(error("\"rows\": [\"0101\"], \"turns\": [\"17\"]"), "");
  EXPECT_EQ(error("\"turns\": [\"08\"]"),
            "key map.turns[0]: has a cell, number 1, that is not a digit from 0 to 7");
  EXPECT_EQ(error("\"turns\": [\"111\"]"),
            "key map.turns[0]: must be a string of a digit for each cell of the row, or fewer");
  EXPECT_EQ(error("\"turns\": 1"), "key map.turns: must be a list of as many rows as the map has, or fewer");
}

TEST(TurnedTiles, AreSharedByVersions) {
  const Level level = level_of({{kRise, TileTurn::left_right}, kRise});
  const LevelVersion before = version_of(level);
  EXPECT_EQ(level_of(before).map, level.map);
  Level edited = level;
  edited.map.set({1, 1}, {kRise, TileTurn::up_down});
  const LevelVersion after = version_of(edited, &before);
  EXPECT_EQ(after.layers[0].rows[0], before.layers[0].rows[0]);
  EXPECT_THAT(changed_cells(before, after, 10), testing::Optional(ElementsAre(Cell{1, 1})));
}

// The mirror image of a level turns its tiles the other way.
TEST(TurnedTiles, AreMirroredWithALevel) {
  for (const TileTurn turn : all_turns()) {
    const Level level = level_of({{kRise, turn}, kRise, 0});
    const Terrain ground = terrain_of(level), image = terrain_of(mirrored(level));
    for (double x = 0.25; x < 24; x += 1.5) {
      for (double y = 8.25; y < 16; y += 1.5) {
        EXPECT_EQ(overlaps_ground(ground, Rect{x, y, 0.5, 0.5}),
                  overlaps_ground(image, Rect{24 - x - 0.5, y, 0.5, 0.5}))
            << static_cast<int>(turn) << " at " << x << ", " << y;
      }
    }
  }
}

}  // namespace talus::tile_turns_test
