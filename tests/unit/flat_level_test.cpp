// Levels with layers for formats that have one.
#include <gmock/gmock.h>

#include <talus/level/ground.h>
#include "collision/ground_queries.h"
#include "export/flat_level.h"
#include "level/ground_level.h"
#include "level/lint/fixes.h"

namespace talus {
namespace {

constexpr TileNumber kBlock = 1, kRamp = 2, kLeaf = 3;

// 2x1 cells, each with a hill behind grass, which is drawn in colour 5 on the left half of the tile.
Level two_layers() {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(2, 1);
  level.tile_shapes[kBlock] = {.kind = TileShape::Kind::solid};
  level.tile_shapes[kRamp] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.sheet(SheetId::tiles).images[kRamp].fill(2);
  for (std::size_t pixel = 0; pixel < 64; ++pixel)
    level.sheet(SheetId::tiles).images[kLeaf][pixel] = pixel % 8 < 4 ? 5 : 0;
  level.sheet(SheetId::tiles).flags[kLeaf] = 1 << 7;
  level.map.cells().tiles() = {kRamp, kRamp};
  level.layers.list.push_back({.name = "front",
                               .is_ground = false,
                               .cells = std::make_shared<const MapCells>(std::vector<TileNumber>{kLeaf, 0})});
  return level;
}

TEST(FlatLevel, AStackIsATileOfItsOwn) {
  const auto flat = flat_level(two_layers());
  ASSERT_TRUE(flat);
  EXPECT_THAT(flat->level.map.cells().tiles(), testing::ElementsAre(256, kRamp));
  EXPECT_TRUE(flat->level.layers.is_plain());
  EXPECT_EQ(flat->level.tile_shapes[256], two_layers().tile_shapes[kRamp]);
  EXPECT_EQ(flat->level.tile_flags(256), 1 << 7);
  const TileImage& image = flat->level.sheet(SheetId::tiles).images[256];
  EXPECT_EQ(image[0], 5);
  EXPECT_EQ(image[7], 2) << "colour 0 shows what is behind";
  EXPECT_TRUE(flat->dropped.empty());
}

TEST(FlatLevel, WhatIsOnlyDrawnIsNoGround) {
  Level level = two_layers();
  level.tile_shapes[kLeaf] = {.kind = TileShape::Kind::solid};
  level.map.cells().tiles() = {0, kBlock};
  const auto flat = flat_level(level);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->level.map.at({0, 0}), 256) << "grass without its shape";
  EXPECT_FALSE(overlaps_ground(terrain_of(flat->level), Rect{1, 1, 4, 4}));
  EXPECT_TRUE(overlaps_ground(terrain_of(flat->level), Rect{9, 1, 4, 4}));
}

TEST(FlatLevel, HiddenGroundStays) {
  Level level = two_layers();
  level.layers.list.front().visible = false;
  const auto flat = flat_level(level);
  ASSERT_TRUE(flat);
  EXPECT_TRUE(overlaps_ground(terrain_of(flat->level), Rect{12, 4, 3, 3}));
  const TileNumber hill = flat->level.map.tile_at({1, 0});
  EXPECT_EQ(flat->level.sheet(SheetId::tiles).images[hill], TileImage{});
}

TEST(FlatLevel, OpacityAndTintAreInThePicture) {
  Level level = two_layers();
  level.layers.list.back().opacity = 0.5;
  level.layers.list.back().tint = {255, 0, 255};
  level.layers.list.back().offset = {1, 0};
  level.palette[2] = {100, 100, 100};
  level.palette[5] = {200, 200, 0};
  const auto flat = flat_level(level);
  ASSERT_TRUE(flat);
  const Sheet& sheet = flat->level.sheet(SheetId::tiles);
  ASSERT_TRUE(sheet.picture);
  const Cell place = sheet.layout().place_of(256);
  const std::uint8_t* pixel = sheet.picture->at(8 * place.x, 8 * place.y);
  EXPECT_THAT(std::vector<int>(pixel, pixel + 4), testing::ElementsAre(150, 50, 50, 255));
  EXPECT_THAT(flat->dropped, testing::ElementsAre("the offset of the layer \"front\""));
}

TEST(GroundLevel, HasTheGroundOfAllLayers) {
  Level level = two_layers();
  level.layers.list.back().is_ground = true;
  level.tile_shapes[kLeaf] = {.kind = TileShape::Kind::solid, .one_way = true};
  const Level ground = ground_level(level);
  EXPECT_THAT(ground.map.cells().tiles(), testing::ElementsAre(256, kRamp));
  EXPECT_EQ(ground.tile_shapes[256].parts.size(), 2u);
}

TEST(GroundLevel, FollowsCells) {
  Level level = two_layers();
  Level ground = ground_level(level);
  level.map.set({1, 0}, kBlock);
  EXPECT_TRUE(update_cell(level, {1, 0}, ground));
  EXPECT_EQ(ground, ground_level(level));
}

// A hill whose right half is missing: a problem of the layer that is ground, with a fix there alone.
TEST(GroundLevel, ProblemsAreThoseOfTheGround) {
  Level level = two_layers();
  level.map.cells().tiles() = {0, 0};
  level.tile_shapes[kRamp].tiles = 2;
  level.map.set({1, 0}, kRamp);
  const std::vector<Problem> problems = lint(level);
  Level alone = level;
  alone.layers = {};
  EXPECT_EQ(problems, lint(alone));
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(fixes_for(level, ground_level(level), {}, problems.front()).size(),
            fixes_for(alone, alone, {}, problems.front()).size());
  level.choose_layer(1);
  EXPECT_EQ(lint(level), problems) << "whichever layer is chosen";
  for (const Edit& edit : fixes_for(level, ground_level(level), {}, problems.front()))
    for (const Change& change : edit.changes) EXPECT_FALSE(std::holds_alternative<CellChange>(change));
}

// A one-way side that a quarter turn makes no ground of.
TEST(GroundLevel, ProblemsNameATurnedTileByItsTileAndItsTurn) {
  Level level = two_layers();
  level.map.cells().tiles() = {0, 0};
  level.tile_shapes[kBlock] = {.kind = TileShape::Kind::solid, .one_way = true};
  level.map.set({1, 0}, MapCell(kBlock, kTurnRight));
  const std::vector<Problem> problems = lint(level);
  const std::string name = "tile " + std::to_string(kBlock) + ", turned right,";
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
    return problem.message.find(name) != std::string::npos;
  })) << testing::PrintToString([&] {
    std::vector<std::string> messages;
    for (const Problem& problem : problems) messages.push_back(problem.message);
    return messages;
  }());
  for (const Problem& problem : problems)
    EXPECT_EQ(problem.message.find("tile 256"), std::string::npos) << problem.message;
}

TEST(GroundNames, NameTilesTurnsStacksAndObjects) {
  const GroundNames names(10, 12, {{MapCell(3, TileTurn::left_right)}, {MapCell(3), MapCell(7)}});
  EXPECT_EQ(names.text_of(9), "tile 9");
  EXPECT_EQ(names.text_of(11), "an object");
  EXPECT_EQ(names.text_of(12), "tile 3, mirrored,");
  EXPECT_EQ(names.text_of(13), "tile 3 with tile 7");
  EXPECT_EQ(GroundNames().text_of(13), "tile 13");
}

}  // namespace
}  // namespace talus
