// Shapes of tiles: proposed from pixels, extended over tiles, mirrored, copied and given to many tiles.
#include "edit/tile_shapes.h"

#include <gtest/gtest.h>

#include <string_view>

#include "edit/auto_tile.h"

namespace talus::tile_shapes_test {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

// Eight rows of eight pixels for each tile, side by side; '#' is opaque.
void draw_tile_rows(Level& level, int tile, std::initializer_list<std::string_view> rows) {
  int y = 0;
  for (const std::string_view row : rows) {
    for (int x = 0; x < static_cast<int>(row.size()); ++x)
      level.sheet(SheetId::tiles).images[tile + x / 8][y * 8 + x % 8] =
          row[static_cast<std::size_t>(x)] == '#' ? 5 : 0;
    ++y;
  }
}

std::optional<TileShape> suggested(std::initializer_list<std::string_view> rows, int tiles = 1) {
  Level level;
  draw_tile_rows(level, 3, rows);
  return suggest_shape(level, 3, tiles);
}

TileShape sloped(std::vector<double> heights, Side side = Side::floor, int tiles = 1) {
  return {.kind = Kind::slope, .side = side, .tiles = tiles, .heights = std::move(heights)};
}

TEST(TileShapes, AreProposedForEmptyAndFullTiles) {
  EXPECT_EQ(suggested({}), std::nullopt);
  const auto row = "########";
  EXPECT_EQ(suggested({row, row, row, row, row, row, row, row}), TileShape{.kind = Kind::solid});
  const auto hollow = "#......#";
  EXPECT_EQ(suggested({row, hollow, hollow, hollow, hollow, hollow, hollow, row}),
            TileShape{.kind = Kind::solid})
      << "its outline counts";
}

TEST(TileShapes, AreProposedForTheStairsOfASlope) {
  EXPECT_EQ(suggested({".......#", "......##", ".....###", "....####", "...#####", "..######", ".#######",
                       "########"}),
            sloped({0, 8}));
  EXPECT_EQ(suggested({"........", "#.......", "##......", "###.....", "####....", "#####...", "######..",
                       "#######."}),
            sloped({8, 0}))
      << "a line that is one pixel lower gives the same shape";
  EXPECT_EQ(suggested({"", "", "", "", ".......#", ".....###", "...#####", ".#######"}), sloped({0, 4}));
  EXPECT_EQ(suggested({"", "", "", "", "", "########", "########", "########"}), sloped({3, 3}));
}

TEST(TileShapes, AreProposedForCeilings) {
  EXPECT_EQ(suggested({"########", "#######.", "######..", "#####...", "####....", "###.....", "##......",
                       "#......."}),
            sloped({8, 0}, Side::ceiling));
  EXPECT_EQ(suggested({"########", "########", "", "", "", "", "", ""}), sloped({2, 2}, Side::ceiling));
}

TEST(TileShapes, AProfileIsProposedForABump) {
  const auto shape = suggested({"", "", "", "", "...##...", "..####..", ".######.", "########"});
  EXPECT_EQ(shape, (TileShape{.kind = Kind::profile, .heights = {1, 1.5, 2.5, 3.5, 4, 3.5, 2.5, 1.5, 1}}));
}

TEST(TileShapes, AreProposedOverTwoTiles) {
  EXPECT_EQ(suggested({"..............##", "............####", "..........######", "........########",
                       "......##########", "....############", "..##############", "################"},
                      2),
            sloped({0, 8}, Side::floor, 2));
}

TEST(TileShapes, AreProposedForHalvesOfTheSameStairs) {
  EXPECT_EQ(suggested({"", "", "", "", "......##", "....####", "..######", "########"}), sloped({0, 4}));
  EXPECT_EQ(suggested({"", "", "", "", "", "......##", "....####", "..######"}), sloped({0, 4}));
  EXPECT_EQ(suggested({"......##", "....####", "..######", "########", "########", "########", "########",
                       "########"}),
            sloped({4, 8}));
}

TEST(TileShapes, AreSuggestedForAllSelectedTilesAtOnce) {
  Level level;
  const auto row = "########........########";
  draw_tile_rows(level, 3, {row, row, row, row, row, row, row, row});
  level.tile_shapes[4] = sloped({1, 2});
  level.tile_shapes[5] = {.kind = Kind::solid};
  const Edit edit = suggest_shapes(level, {SheetId::tiles, {3, 0, 3, 1}});
  ASSERT_EQ(edit.changes.size(), 1u) << "a clear tile keeps its shape, and so does one that has it already";
  apply_edit(level, edit);
  EXPECT_EQ(level.tile_shapes[3], TileShape{.kind = Kind::solid});
  EXPECT_EQ(level.tile_shapes[4], sloped({1, 2}));
}

TEST(TileShapes, OneShapeForManyTilesIsOneEdit) {
  Level level;
  const Level before = level;
  const Edit edit = give_shape(level, {SheetId::tiles, {3, 1, 2, 2}}, sloped({0, 8}));
  apply_edit(level, edit);
  for (const int tile : {19, 20, 35, 36}) EXPECT_EQ(level.tile_shapes[tile], sloped({0, 8})) << tile;
  EXPECT_EQ(level.tile_shapes[21], TileShape());
  revert_edit(level, edit);
  EXPECT_EQ(level, before);
}

TEST(TileShapes, AChangeIsMadeInAllTilesThatHaveTheShape) {
  Level level;
  level.tile_shapes[3] = sloped({0, 8}, Side::floor, 2);  // over tile 4
  level.tile_shapes[5] = sloped({6, 2});
  level.tile_shapes[6] = {.kind = Kind::solid};
  const SpriteArea area{SheetId::tiles, {3, 0, 4, 1}};
  TileShape wanted = sloped({1, 8}, Side::ceiling, 2);
  wanted.one_way = true;
  apply_edit(level, change_shapes(level, area, wanted));
  EXPECT_EQ(level.tile_shapes[3], wanted);
  EXPECT_EQ(level.tile_shapes[4], TileShape());
  EXPECT_EQ(level.tile_shapes[5].heights, (std::vector<double>{1, 2})) << "its other end stays";
  EXPECT_EQ(level.tile_shapes[5].side, Side::ceiling);
  EXPECT_EQ(level.tile_shapes[5].tiles, 1);
  EXPECT_EQ(level.tile_shapes[6], (TileShape{.kind = Kind::solid, .one_way = true}));
  apply_edit(level, change_kinds(level, area, Kind::slope));
  EXPECT_EQ(level.tile_shapes[3], wanted) << "one already";
  EXPECT_EQ(level.tile_shapes[4], TileShape());
  EXPECT_EQ(level.tile_shapes[6].kind, Kind::slope);
}

TEST(TileShapes, KindsAndWidthsKeepTheLine) {
  const TileShape profile = with_kind(sloped({0, 8}), Kind::profile, {});
  EXPECT_EQ(profile, (TileShape{.kind = Kind::profile, .heights = {0, 1, 2, 3, 4, 5, 6, 7, 8}}));
  EXPECT_EQ(with_kind(profile, Kind::slope, {}), sloped({0, 8}));
  EXPECT_EQ(with_kind({.kind = Kind::solid}, Kind::profile, {}).heights, std::vector<double>(9, 8));
  const TileShape wide = with_width(profile, 2, {});
  EXPECT_EQ(wide.tiles, 2);
  ASSERT_EQ(wide.heights.size(), 17u);
  EXPECT_EQ(wide.heights[8], 4);
  EXPECT_FALSE(problem_of(with_width(profile, 8, {}), {}));
  EXPECT_EQ(with_width(sloped({2, 6}), 3, {}), sloped({2, 6}, Side::floor, 3));
  EXPECT_EQ(with_kind(sloped({2, 6}, Side::ceiling, 3), Kind::solid, {}), TileShape{.kind = Kind::solid});
}

TEST(TileShapes, FillTilesOfAnySize) {
  constexpr TileSize kTile{16, 24};
  Level level;
  level.map = TileMap(4, 4, kTile);
  const auto row = "########";
  draw_tile_rows(level, 3, {row, row, row, row, row, row, row, row});
  EXPECT_EQ(suggest_shape(level, 3), TileShape{.kind = Kind::solid});
  draw_tile_rows(
      level, 4,
      {".......#", "......##", ".....###", "....####", "...#####", "..######", ".#######", "########"});
  EXPECT_EQ(suggest_shape(level, 4), sloped({0, 24}));
  const TileShape profile = with_kind({.kind = Kind::solid}, Kind::profile, kTile);
  EXPECT_EQ(profile.heights, std::vector<double>(17, 24)) << "a height for each px of its width";
  EXPECT_EQ(with_width(profile, 2, kTile).heights.size(), 33u);
  EXPECT_EQ(tiles_of_shape(level, 35, sloped({0, 24})), (CellRect{3, 2, 1, 1}));
  EXPECT_EQ(tiles_of_shape(level, 35, sloped({0, 25})), (CellRect{3, 1, 1, 2}));
}

TEST(TileShapes, AreTurned) {
  const TileShape shape = sloped({1, 6}, Side::floor, 2);
  EXPECT_EQ(turned(shape, ShapeTurn::mirrored, {}), sloped({6, 1}, Side::floor, 2));
  EXPECT_EQ(turned(shape, ShapeTurn::upside_down, {}), sloped({1, 6}, Side::ceiling, 2));
  EXPECT_EQ(turned(shape, ShapeTurn::half_turn, {}), sloped({6, 1}, Side::ceiling, 2));
  EXPECT_EQ(tiles_of_shape(Level(), 35, shape), (CellRect{3, 2, 2, 1}));
  EXPECT_EQ(tiles_of_shape(Level(), 35, sloped({0, 12})), (CellRect{3, 1, 1, 2}))
      << "a floor rises into the tile above";
  EXPECT_EQ(tiles_of_shape(Level(), 35, sloped({0, 12}, Side::ceiling)), (CellRect{3, 2, 1, 2}));
}

TEST(TileShapes, MirroredCopyTakesPixelsAndShapeAsOneEdit) {
  Level level;
  draw_tile_rows(level, 3, {"", "", "", "", "", "", "............####", "....############"});
  level.tile_shapes[3] = sloped({0, 4}, Side::floor, 2);
  const Level before = level;
  const auto edit = copy_turned(level, 3, 40, ShapeTurn::mirrored);
  ASSERT_TRUE(edit);
  apply_edit(level, *edit);
  EXPECT_EQ(level.tile_shapes[40], sloped({4, 0}, Side::floor, 2));
  const auto& images = level.sheet(SheetId::tiles).images;
  EXPECT_EQ(images[40][6 * 8 + 3], 5);
  EXPECT_EQ(images[40][6 * 8 + 4], 0);
  EXPECT_EQ(images[41][7 * 8 + 3], 5);
  EXPECT_EQ(images[41][7 * 8 + 4], 0);
  EXPECT_EQ(images[3], before.sheet(SheetId::tiles).images[3]);
  revert_edit(level, *edit);
  EXPECT_EQ(level, before);
}

TEST(TileShapes, TileIsTurnedInItsPlace) {
  Level level;
  draw_tile_rows(level, 3, {"", "", "", "", "", "", "", "#......."});
  level.tile_shapes[3] = sloped({2, 0});
  apply_edit(level, copy_turned(level, 3, 3, ShapeTurn::half_turn).value());
  EXPECT_EQ(level.tile_shapes[3], sloped({0, 2}, Side::ceiling));
  EXPECT_EQ(level.sheet(SheetId::tiles).images[3][7], 5);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[3][56], 0);
}

TEST(TileShapes, CopyWithoutRoomSaysWhy) {
  Level level;
  level.tile_shapes[3] = sloped({0, 8}, Side::floor, 2);
  EXPECT_EQ(copy_turned(level, 3, 15, ShapeTurn::mirrored).error(),
            "a copy over 2x1 tiles has no room at tile 15");
  EXPECT_EQ(copy_turned(level, 3, 4, ShapeTurn::mirrored).error(),
            "a copy at tile 4 would lie over part of its original");
  level.tile_shapes[15] = sloped({0, 8}, Side::floor, 2);
  EXPECT_EQ(copy_turned(level, 15, 40, ShapeTurn::none).error(),
            "tile 15 has a shape over 2x1 tiles, which reaches beyond the sheet");
}

TEST(TileShapes, FreeTargetHasRoomForAllTiles) {
  Level level;
  for (int tile = 0; tile < 40; ++tile) level.sheet(SheetId::tiles).images[tile].fill(5);
  level.tile_shapes[3] = sloped({0, 8}, Side::floor, 2);
  level.tile_shapes[41] = {.kind = Kind::solid};
  EXPECT_EQ(free_target(level, 3, ShapeTurn::mirrored), 42);
  for (auto& image : level.sheet(SheetId::tiles).images) image.fill(5);
  EXPECT_EQ(free_target(level, 3, ShapeTurn::mirrored), std::nullopt);
}

TEST(TileShapes, WideShapesExtendOverTilesToTheRight) {
  Level level;
  level.tile_shapes[3] = sloped({0, 8}, Side::floor, 3);
  level.tile_shapes[5] = {.kind = Kind::solid};
  level.tile_shapes[15] = sloped({0, 8}, Side::floor, 2);
  EXPECT_EQ(tile_reaching_over(level, 3), std::nullopt);
  EXPECT_EQ(tile_reaching_over(level, 4), 3);
  EXPECT_EQ(tile_reaching_over(level, 5), std::nullopt) << "it has a shape itself";
  EXPECT_EQ(tile_reaching_over(level, 6), std::nullopt);
  EXPECT_EQ(tile_reaching_over(level, 16), std::nullopt) << "not over the edge of the sheet";
}

TEST(TileShapes, CopySaysWhatItReplaces) {
  Level level;
  level.tile_shapes[3] = sloped({0, 8}, Side::floor, 2);
  draw_tile_rows(level, 1, {"#"});
  level.tile_shapes[8] = {.kind = Kind::solid};
  const auto replaced = [&](int target) { return tiles_replaced(level, 3, target, ShapeTurn::mirrored); };
  EXPECT_EQ(replaced(1), std::vector<int>{1});
  EXPECT_EQ(replaced(7), std::vector<int>{8});
  EXPECT_EQ(replaced(10), std::vector<int>());
  EXPECT_EQ(replaced(3), std::vector<int>()) << "turned in its place";
  EXPECT_EQ(replaced(15), std::vector<int>()) << "no room";
}

// A sheet of two tiles of 16x16 px in true colour. Black is a colour as any other, and so is what is opaque.
Level level_in_true_color(FunctionRef<bool(int x, int y)> is_opaque) {
  Level level;
  level.map = TileMap(4, 4, {16, 16});
  level.set_tile_layout({2, 2});
  SheetPicture picture{32, 16, std::vector<std::uint8_t>(32 * 16 * 4)};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      picture.rgba[static_cast<std::size_t>(4 * (y * 32 + x) + 3)] = is_opaque(x, y) ? 255 : 0;
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  return level;
}

TEST(TileShapes, SuggestionsInTrueColourLookAtOpacity) {
  const Level block = level_in_true_color([](int, int) { return true; });
  EXPECT_EQ(suggest_shape(block, 1), TileShape{.kind = Kind::solid});
  Level half = block;  // its black lower half is colour 0 of the image
  for (std::size_t i = 0; i < 32; ++i) half.sheet(SheetId::tiles).images[1][i] = 3;
  EXPECT_EQ(suggest_shape(half, 1), TileShape{.kind = Kind::solid});
  const Level ramp = level_in_true_color([](int x, int y) { return x >= 16 && y >= 15 - (x - 16) / 2; });
  EXPECT_EQ(suggest_shape(ramp, 0), std::nullopt);
  EXPECT_EQ(suggest_shape(ramp, 1), (TileShape{.kind = Kind::slope, .heights = {0, 8}}));
}

TEST(TileShapes, SuggestionsKeepOneWayPlanksOneWay) {
  Level plank = level_in_true_color([](int, int y) { return y < 5; });
  plank.tile_shapes[1] = {.kind = Kind::slope, .one_way = true, .heights = {7, 7}};
  EXPECT_EQ(suggest_shape(plank, 1), (TileShape{.kind = Kind::solid, .one_way = true}));
}

TEST(TileShapes, SuggestionsForLevelTopsAreExact) {
  const Level level = level_in_true_color([](int x, int y) { return x >= 16 ? y >= 1 : y < 3; });
  EXPECT_EQ(suggest_shape(level, 0), sloped({3, 3}, Side::ceiling));
  EXPECT_EQ(suggest_shape(level, 1), sloped({15, 15}));
}

TEST(TileShapes, OpaqueTilesInTrueColourBecomeGround) {
  const Level level = level_in_true_color([](int x, int y) { return x >= 16 || y < 3; });
  constexpr std::array<TileNumber, 2> kBoth = {0, 1};
  EXPECT_EQ(proposed_auto_tiles(level, kBoth).of(GroundPart::inside), 1);
  Level proposed = level;
  apply_edit(proposed, propose_auto_tiles(level, kBoth));
  EXPECT_EQ(proposed.auto_tiles.of(GroundPart::inside), 1);
  EXPECT_EQ(proposed.tile_shapes[1].kind, Kind::solid);
  EXPECT_EQ(proposed.tile_shapes[0].kind, Kind::none);
}

}  // namespace talus::tile_shapes_test
