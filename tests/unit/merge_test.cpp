// Levels that were changed in two places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level/merge.h"
#include "level/moved_ground.h"

namespace talus::merge_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Spawn body(const std::string& name, Vec2 position) {
  return {.name = name, .position = position, .velocity = {}, .extra = ""};
}

Level small_level() {
  Level level;
  level.map = TileMap(4, 4);
  level.layers.list[0].name = "a";
  level.spawns = {body("hero", {1, 1}), body("", {9, 9})};
  return level;
}

Spawn body_at(double x) { return body("new", {x, 0}); }

TEST(Merge, TakesCellsFlagsShapesAndBodiesFromEitherSide) {
  const Level base = small_level();
  Level mine = base, theirs = base;
  mine.map.set({0, 0}, 1);
  theirs.map.set({1, 0}, 2);
  mine.sheet(SheetId::tiles).flags[5] = 1;
  theirs.sheet(SheetId::tiles).flags[6] = 2;
  mine.tile_shapes[7].kind = TileShape::Kind::solid;
  theirs.tile_shapes[8].kind = TileShape::Kind::solid;
  mine.spawns[0].position.x = 3;
  mine.spawns.push_back(body_at(1));
  theirs.spawns[1].position.x = 4;
  theirs.spawns.push_back(body_at(2));
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  const Level& level = merged.level;
  EXPECT_EQ(level.map.at({0, 0}), 1);
  EXPECT_EQ(level.map.at({1, 0}), 2);
  EXPECT_EQ(level.sheet(SheetId::tiles).flags[5], 1);
  EXPECT_EQ(level.sheet(SheetId::tiles).flags[6], 2);
  EXPECT_EQ(level.tile_shapes[7].kind, TileShape::Kind::solid);
  EXPECT_EQ(level.tile_shapes[8].kind, TileShape::Kind::solid);
  ASSERT_EQ(level.spawns.size(), 4u);
  EXPECT_EQ(level.spawns[0].position.x, 3);
  EXPECT_EQ(level.spawns[1].position.x, 4);
  EXPECT_EQ(level.spawns[2], body_at(2));
  EXPECT_EQ(level.spawns[3], body_at(1));
}

TEST(Merge, OfAnUnchangedSideIsTheOther) {
  const Level base = small_level();
  Level other = base;
  other.map = TileMap(6, 2);
  other.map.set({5, 1}, 3);
  other.palette[3] = {1, 2, 3};
  other.spawns.erase(other.spawns.begin());
  other.tuning.shared.fall_speed = 7;
  EXPECT_EQ(merge_levels(base, base, other, MergeSide::mine).level, other);
  EXPECT_EQ(merge_levels(base, other, base, MergeSide::theirs).level, other);
  EXPECT_THAT(merge_levels(base, other, other, MergeSide::mine).conflicts, IsEmpty());
}

TEST(Merge, CountsWhatBothChangedAndAsksWhichSide) {
  const Level base = small_level();
  Level mine = base, theirs = base;
  for (int x = 0; x < 3; ++x) {
    mine.map.set({x, 0}, 1);
    theirs.map.set({x, 0}, 2);
  }
  mine.tile_shapes[7].kind = TileShape::Kind::solid;
  theirs.tile_shapes[7].kind = TileShape::Kind::slope;
  mine.spawns[0].position.x = 3;
  theirs.spawns.erase(theirs.spawns.begin());
  const MergedLevel kept = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(kept.conflicts, ElementsAre("3 cells", "1 shape", "1 body"));
  EXPECT_EQ(kept.level.map.at({2, 0}), 1);
  EXPECT_EQ(kept.level.tile_shapes[7].kind, TileShape::Kind::solid);
  EXPECT_EQ(kept.level.spawns.size(), 2u);
  const MergedLevel taken = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_EQ(taken.level.map.at({2, 0}), 2);
  EXPECT_EQ(taken.level.tile_shapes[7].kind, TileShape::Kind::slope);
  EXPECT_EQ(taken.level.spawns.size(), 1u);
}

TEST(Merge, LargerMapsKeepTheCellsThatWerePaintedHere) {
  const Level base = small_level();
  Level mine = base, theirs = base;
  mine.map.set({3, 3}, 1);
  theirs.map = TileMap(8, 2);
  theirs.map.set({7, 1}, 2);
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_EQ(merged.level.map.width(), 8);
  EXPECT_EQ(merged.level.map.at({7, 1}), 2);
  EXPECT_THAT(merged.conflicts, ElementsAre("1 cell")) << "the file's map has no row 3 any more";
}

TEST(Merge, FollowsLayersByTheirNames) {
  Level base = small_level();
  TileLayer second;
  second.name = "b";
  second.cells = std::make_shared<const std::remove_cvref_t<decltype(base.map.cells())>>(base.map.cells());
  base.layers.list.push_back(second);
  Level mine = base, theirs = base;
  mine.choose_layer(1);
  mine.map.set({1, 1}, 5);
  theirs.map.set({0, 0}, 4);
  std::swap(theirs.layers.list[0], theirs.layers.list[1]);
  theirs.layers.chosen = 1;
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(merged.level.layers.list[0].name, "b");
  EXPECT_EQ(merged.level.layers.chosen, 0) << "the chosen layer is still b";
  EXPECT_EQ(merged.level.map.at({1, 1}), 5);
  EXPECT_EQ(merged.level.cells_of(1)[0], 4);
}

// Fails to compile if a level gets one more part: add it here, and to merge.cpp.
TEST(Merge, TakesEveryPartOfALevel) {
  const Level base = small_level();
  Level mine = base;
  mine.sheet(SheetId::tiles).flags[9] = 4;
  mine.palette[2] = {9, 9, 9};
  mine.background = Rgba{1, 2, 3, 4};
  mine.flag_names[3] = "lava";
  mine.flag_fields = {{.name = "kind", .first = 4, .bits = 2, .values = {}, .extra = ""}};
  mine.roles.one_way = 7;
  mine.tile_shapes[9].kind = TileShape::Kind::solid;
  mine.flag_shapes[3].kind = TileShape::Kind::solid;
  mine.tilesets = {{.name = "all", .count = kCartTiles, .columns = kCartColumns}};
  mine.animations[9] = {{8, 100}};
  mine.tile_notes[9].type = "lava";
  mine.large_tiles[9].size = {16, 24};
  mine.layers.list[0].opacity = 0.5;
  mine.map.set({2, 2}, {9, kTurnRight});
  mine.curves = {{.name = "hill", .curve = {.form = Segment{{0, 8}, {8, 4}}}, .extra = ""}};
  mine.objects = {{.name = "things", .objects = {{.name = "coin", .position = {3, 4}}}}};
  mine.tuning.shared.fall_speed = 7;
  mine.spawns.push_back(body_at(5));
  mine.brushes = {{.name = "one", .extra = ""}};
  mine.auto_tiles.of(GroundPart{}) = 9;
  mine.exports = {{.name = "game", .exporter = "love", .path = "game", .extra = ""}};
  mine.extra = R"({"new":1})";
  const auto& [sheets, palette, background, flag_names, flag_fields, roles, tile_shapes, flag_shapes,
               tilesets, animations, tile_notes, large_tiles, layers, map, curves, objects, tuning, spawns,
               brushes, auto_tiles, exports, cart, tiled, ldtk, extra] = mine;
  EXPECT_FALSE(sheets == base.sheets || palette == base.palette || background == base.background ||
               flag_names == base.flag_names || flag_fields == base.flag_fields || roles == base.roles ||
               tile_shapes == base.tile_shapes || flag_shapes == base.flag_shapes ||
               tilesets == base.tilesets || animations == base.animations || tile_notes == base.tile_notes ||
               large_tiles == base.large_tiles || layers == base.layers);
  EXPECT_FALSE(map.cells() == base.map.cells() || curves == base.curves || objects == base.objects ||
               tuning == base.tuning || spawns == base.spawns || brushes == base.brushes ||
               auto_tiles == base.auto_tiles || exports == base.exports || extra == base.extra);
  EXPECT_TRUE(cart == nullptr && tiled == nullptr && ldtk == nullptr) << "these are always those of the file";
  Level theirs = base, both = mine;
  theirs.palette[15] = both.palette[15] = {1, 2, 3};
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(merged.level, both);
  EXPECT_EQ(merge_levels(base, theirs, mine, MergeSide::mine).level, both);
}

TEST(Merge, GoesThroughObjectsOneByOne) {
  Level base = small_level();
  base.objects = {{.name = "a", .objects = {{.name = "coin", .position = {1, 1}}, {.name = "door"}}},
                  {.name = "b"}};
  Level mine = base, theirs = base;
  mine.objects[0].objects[0].position = {5, 5};
  mine.objects[0].is_ground = true;
  theirs.objects[0].objects[1].properties = R"({"to":"cave"})";
  theirs.objects[0].objects.push_back({.name = "key"});
  theirs.objects.push_back({.name = "c"});
  MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  ASSERT_EQ(merged.level.objects.size(), 3u);
  const ObjectLayer& layer = merged.level.objects[0];
  ASSERT_EQ(layer.objects.size(), 3u);
  EXPECT_TRUE(layer.is_ground);
  EXPECT_EQ(layer.objects[0].position, (Vec2{5, 5}));
  EXPECT_EQ(layer.objects[1].properties, R"({"to":"cave"})");
  theirs.objects[0].objects[0].position = {6, 6};
  merged = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_THAT(merged.conflicts, ElementsAre("1 object"));
  EXPECT_EQ(merged.level.objects[0].objects[0].position, (Vec2{6, 6}));
}

// A level of 16 tiles in two columns, each in one colour.
Level coloured_level() {
  Level level = small_level();
  level.set_tile_layout({2, 16});
  SheetPicture picture{16, 64, std::vector<std::uint8_t>(4 * 16 * 64, 40)};
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  return level;
}

void paint_tile(Level& level, int tile, std::uint8_t value) {
  Sheet& sheet = level.sheet(SheetId::tiles);
  auto picture = std::make_shared<SheetPicture>(*sheet.picture);
  const Cell place = sheet.layout().place_of(tile);
  for (int y = 8 * place.y; y < 8 * place.y + 8; ++y)
    std::fill_n(
        &picture->rgba[4 * (16 * static_cast<std::size_t>(y) + 8 * static_cast<std::size_t>(place.x))], 4 * 8,
        value);
  sheet.picture = std::move(picture);
}

TEST(Merge, GoesThroughPicturesTileByTile) {
  const Level base = coloured_level();
  Level mine = base, theirs = base, both = base;
  paint_tile(mine, 3, 90);
  paint_tile(theirs, 4, 91);
  paint_tile(both, 3, 90);
  paint_tile(both, 4, 91);
  EXPECT_EQ(merge_levels(base, mine, theirs, MergeSide::mine).level, both);
  paint_tile(theirs, 3, 92);
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, ElementsAre("1 picture of a tile"));
  EXPECT_EQ(merged.level, both);
}

TEST(Merge, OfOtherTileNumbersTakesOneSideAsAWhole) {
  const Level base = small_level();
  Level mine = base, theirs = base;
  mine.map.set({0, 0}, 40);
  theirs.set_tile_layout({8, 256});
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, ElementsAre("the numbers of the tiles"));
  EXPECT_EQ(merged.apart, "the numbers of the tiles are others there than here");
  EXPECT_EQ(merged.level, mine);
}

// A level with ground by which its place is found again.
Level level_with_ground() {
  Level level = small_level();
  level.map.cells().tiles() = {0, 1, 2, 0, 3, 4, 5, 0, 6, 7, 8, 9, 1, 2, 3, 4};
  return level;
}
Level with_columns_at_left(const Level& level, int count) {
  return with_moved_ground(level, {count, 0}, level.map.width() + count, level.map.height());
}

TEST(Merge, GroundThatWasMovedHereTakesTheirChangesAlong) {
  const Level base = level_with_ground();
  Level theirs = base;
  theirs.map.set({3, 0}, 7);
  theirs.spawns[0].position = {3, 3};
  const Level wide = with_columns_at_left(base, 2);
  for (const MergeSide side : {MergeSide::mine, MergeSide::theirs}) {
    const MergedLevel merged = merge_levels(base, wide, theirs, side);
    EXPECT_THAT(merged.conflicts, IsEmpty());
    EXPECT_EQ(merged.level, with_columns_at_left(theirs, 2));
  }
  EXPECT_EQ(merge_levels(base, wide, wide, MergeSide::mine).level, wide);
}

TEST(Merge, GroundThatWasMovedHereLosesNoChangeInSilence) {
  const Level base = with_columns_at_left(level_with_ground(), 1);
  Level theirs = base;
  theirs.map.set({0, 0}, 7);
  const Level narrow = level_with_ground();
  const MergedLevel merged = merge_levels(base, narrow, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, ElementsAre("1 cell that the map no longer has"));
  EXPECT_EQ(merged.level, narrow);
}

TEST(Merge, GroundThatBothMovedIsAskedAbout) {
  const Level base = level_with_ground();
  Level mine = base, theirs = base;
  mine.map.set({3, 0}, 7);
  theirs.map.set({3, 1}, 8);
  Level both = mine;
  both.map.set({3, 1}, 8);
  mine = with_columns_at_left(mine, 1);
  theirs = with_columns_at_left(theirs, 2);
  const MergedLevel kept = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(kept.conflicts, ElementsAre("the place of the ground"));
  EXPECT_EQ(kept.level, with_columns_at_left(both, 1));
  EXPECT_EQ(merge_levels(base, mine, theirs, MergeSide::theirs).level, with_columns_at_left(both, 2));
}

// A map may have 65,536 tiles of this size side by side.
TEST(Merge, GroundWithoutRoomForBothIsThatOfTheSide) {
  constexpr int kMax = 65536;
  constexpr TileSize kWide{256, 8};
  Level base;
  base.map = TileMap(kMax - 1, 1, kWide);
  for (int x = 0; x < 9; ++x) base.map.set({x, 0}, static_cast<TileNumber>(x + 1));
  Level mine = base;
  mine.map = TileMap(kMax, 1, kWide);
  for (int x = 0; x < 9; ++x) mine.map.set({x, 0}, base.map.tile_at({x, 0}));
  mine.map.set({kMax - 1, 0}, 3);
  const Level theirs = with_moved_ground(base, {1, 0}, kMax, 1);
  const MergedLevel kept = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(kept.conflicts, ElementsAre("the place of the ground"));
  EXPECT_NE(kept.apart, "");
  EXPECT_EQ(kept.level, mine);
  EXPECT_EQ(merge_levels(base, mine, theirs, MergeSide::theirs).level, theirs);
}

TEST(Merge, LayersThatAreGroundAreThoseOfEitherSide) {
  Level base = small_level();
  base.layers.list.push_back(base.layers.list[0]);
  base.layers.list[1].name = "b";
  base.layers.list[1].cells = std::make_shared<const MapCells>(base.map.cells());
  Level mine = base, theirs = base;
  mine.layers.list[0].is_ground = !base.layers.list[0].is_ground;
  theirs.layers.list[1].is_ground = !base.layers.list[1].is_ground;
  for (const MergeSide side : {MergeSide::mine, MergeSide::theirs}) {
    const MergedLevel merged = merge_levels(base, mine, theirs, side);
    EXPECT_THAT(merged.conflicts, IsEmpty());
    EXPECT_EQ(merged.level.layers.list[0].is_ground, mine.layers.list[0].is_ground);
    EXPECT_EQ(merged.level.layers.list[1].is_ground, theirs.layers.list[1].is_ground);
  }
}

}  // namespace talus::merge_test
