// The ground tool: which tiles it chooses for painted ground, and which tiles it proposes for a sheet.
#include "edit/auto_tile.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <string>

namespace talus::auto_tile_test {

using GroundRows = std::vector<std::string>;

// A letter for each part, in the order of the parts. The tile of a part is its number, from 1. 'u' and 'U'
// are the halves of a long slope up, 'D' and 'd' of one down.
constexpr std::string_view kPartLetters = "#=[]_r7LJ/\\uUDd";

AutoTiles full_set() {
  AutoTiles set;
  std::iota(set.tiles.begin(), set.tiles.end(), TileNumber{1});
  return set;
}

AutoTiles set_without(std::initializer_list<GroundPart> parts) {
  AutoTiles set = full_set();
  for (const GroundPart part : parts) set.of(part) = 0;
  return set;
}

AutoTiles set_with_short_slopes() {
  return set_without({GroundPart::slope_up_left, GroundPart::slope_up_right, GroundPart::slope_down_left,
                      GroundPart::slope_down_right});
}

// '.' is air, 'x' is a tile that is no ground, and each letter of a part is the tile of that part.
Level ground_level(const GroundRows& rows, const AutoTiles& set = full_set()) {
  Level level;
  level.auto_tiles = set;
  level.map = TileMap(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (Cell c{0, 0}; c.y < level.map.height(); ++c.y) {
    for (c.x = 0; c.x < level.map.width(); ++c.x) {
      const char letter = rows[static_cast<std::size_t>(c.y)][static_cast<std::size_t>(c.x)];
      const std::size_t part = kPartLetters.find(letter);
      level.map.set(c, letter == 'x'                    ? 200
                       : part == std::string_view::npos ? 0
                                                        : static_cast<TileNumber>(part + 1));
    }
  }
  return level;
}

GroundRows ground_rows(const TileMap& map) {
  GroundRows rows(static_cast<std::size_t>(map.height()));
  for (Cell c{0, 0}; c.y < map.height(); ++c.y) {
    for (c.x = 0; c.x < map.width(); ++c.x) {
      const std::size_t tile = map.tile_at(c);
      rows[static_cast<std::size_t>(c.y)] += tile == 0 ? '.' : tile == 200 ? 'x' : kPartLetters[tile - 1];
    }
  }
  return rows;
}

// Makes each 'o' of the picture ground, one by one, row by row.
GroundRows painted(const GroundRows& rows, const AutoTiles& set = full_set()) {
  Level level = ground_level(rows, set);
  for (Cell c{0, 0}; c.y < level.map.height(); ++c.y) {
    for (c.x = 0; c.x < level.map.width(); ++c.x) {
      if (rows[static_cast<std::size_t>(c.y)][static_cast<std::size_t>(c.x)] == 'o')
        apply_edit(level, paint_ground(level, c, c, GroundChange::add));
    }
  }
  return ground_rows(level.map);
}

TEST(AutoTile, AnIslandHasSidesCornersAndAnInside) {
  EXPECT_EQ(painted({"......",  //
                     ".oooo.",  //
                     ".oooo.",  //
                     ".oooo.",  //
                     "......"}),
            (GroundRows{"......",  //
                        ".r==7.",  //
                        ".[##].",  //
                        ".L__J.",  //
                        "......"}));
}

TEST(AutoTile, AColumnHasNoSidesAndARowIsATop) {
  EXPECT_EQ(painted({"......",  //
                     ".o.oo.",  //
                     ".o....",  //
                     ".o....",  //
                     "......"}),
            (GroundRows{"......",  //
                        ".=.r7.",  //
                        ".#....",  //
                        "._....",  //
                        "......"}));
}

TEST(AutoTile, GroundGoesOnBeyondTheMap) {
  EXPECT_EQ(painted({"...",  //
                     "ooo",  //
                     "ooo"}),
            (GroundRows{"...",  //
                        "===",  //
                        "###"}));
}

TEST(AutoTile, StairsOfOneCellAreSteepSlopesInBothDirections) {
  EXPECT_EQ(painted({".......",  //
                     "...o...",  //
                     "..ooo..",  //
                     ".ooooo.",  //
                     "ooooooo"}),
            (GroundRows{".......",   //
                        "...=...",   // a slope in both directions is neither
                        "../#\\..",  //
                        "./###\\.",  //
                        "=#####="}));
}

TEST(AutoTile, StairsOfTwoCellsAreLongSlopesWhereTheSetHasThem) {
  const GroundRows stairs = {"............",  //
                             "....oooo....",  //
                             "..oooooooo..",  //
                             "oooooooooooo"};
  EXPECT_EQ(painted(stairs), (GroundRows{"............",  //
                                         "....uUDd....",  //
                                         "..uU####Dd..",  //
                                         "==########=="}));
  EXPECT_EQ(painted(stairs, set_with_short_slopes()), (GroundRows{"............",   //
                                                                  "..../==\\....",  //
                                                                  "../=####=\\..",  //
                                                                  "==########=="}));
}

TEST(AutoTile, AShortHillHasNoRoomForLongSlopes) {
  EXPECT_EQ(painted({".............",  //
                     ".ooo.oo..o...",  //
                     "ooooooooooooo"}),
            (GroundRows{".............",    //
                        "./=\\./\\..=...",  //
                        "=###=##==#==="}));
}

TEST(AutoTile, ACliffAndAnOverhangAreCorners) {
  EXPECT_EQ(painted({"......",  //
                     "..oo..",  // the column two to its left is empty below: a cliff two cells high
                     "..oo..",  //
                     "oooooo"}),
            (GroundRows{"......",  //
                        "..r7..",  //
                        "..[]..",  //
                        "==##=="}));
  EXPECT_EQ(painted({".....",  //
                     "...oo",  //
                     "ooo..",  //
                     "ooo.."}),
            (GroundRows{".....",  //
                        "...r=",  // no ground below it
                        "==7..",  //
                        "##].."}));
}

TEST(AutoTile, ReplacesAMissingPartByTheNextBest) {
  AutoTiles set;
  set.of(GroundPart::inside) = 1;
  const GroundRows island = {".....",  //
                             ".ooo.",  //
                             ".ooo.",  //
                             ".....",  //
                             "....."};
  EXPECT_EQ(painted(island, set)[1], ".###.");
  set.of(GroundPart::left) = 3;
  EXPECT_EQ(painted(island, set)[1], ".[##.");
  set.of(GroundPart::top) = 2;
  EXPECT_EQ(painted(island, set), (GroundRows{".....", ".===.", ".[##.", ".....", "....."}));
  EXPECT_EQ(painted({"...", ".oo", "ooo"}, set), (GroundRows{"...", ".==", "=##"})) << "no slopes at all";
}

TEST(AutoTile, ALongSlopeNeedsBothHalves) {
  EXPECT_EQ(painted({"....", ".ooo", "oooo"}, set_without({GroundPart::slope_up_right})),
            (GroundRows{"....", "./==", "=###"}));
}

TEST(AutoTile, WithoutATileForTheInsideNothingIsPainted) {
  const Level level = ground_level({"...", "..."}, set_without({GroundPart::inside}));
  EXPECT_TRUE(paint_ground(level, {0, 0}, {2, 1}, GroundChange::add).empty());
  EXPECT_TRUE(fill_ground(level, {0, 0, 3, 2}, GroundChange::add).empty());
}

TEST(AutoTile, ChangesOtherTilesOnlyWhereItPaints) {
  EXPECT_EQ(painted({"xox", "xxx"}), (GroundRows{"x_x", "xxx"}));
  Level level = ground_level({"x_x", "xxx"});
  EXPECT_TRUE(paint_ground(level, {0, 0}, {0, 1}, GroundChange::remove).empty()) << "no ground there";
}

TEST(AutoTile, RemovingGroundFitsItsNeighbours) {
  Level level = ground_level({"......",  //
                              ".r==7.",  //
                              ".[##].",  //
                              ".L__J.",  //
                              "......"});
  apply_edit(level, paint_ground(level, {2, 2}, {2, 1}, GroundChange::remove));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{"......",  //
                                                ".=.r7.",  //
                                                ".#.[].",  //
                                                ".L=_J.",  //
                                                "......"}));
}

TEST(AutoTile, RemovingTheMiddleOfASlopeFitsBothHalves) {
  Level level = ground_level({"......", "..uU==", "==####"});
  apply_edit(level, paint_ground(level, {3, 1}, {3, 1}, GroundChange::remove));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{"......", "..=.uU", "==#=##"}));
}

TEST(AutoTile, AFilledRectangleEqualsPaintingInsideTheMap) {
  Level level = ground_level({".....", ".....", "....."});
  apply_edit(level, fill_ground(level, {2, 1, 100, 100}, GroundChange::add));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{".....", "..r==", "..[##"}));
  apply_edit(level, fill_ground(level, {-5, -5, 100, 100}, GroundChange::remove));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{".....", ".....", "....."}));
}

TEST(AutoTile, CellsOutsideTheSelectionStay) {
  Level level = ground_level({".....", "..#..", "....."});
  const CellRect selection{1, 0, 2, 2};
  apply_edit(level, paint_ground(level, {0, 0}, {4, 0}, GroundChange::add, selection));
  EXPECT_EQ(level.map.tile_at({0, 0}) + level.map.tile_at({3, 0}) + level.map.tile_at({4, 0}), 0);
  EXPECT_NE(level.map.at({1, 0}), 0);
  EXPECT_NE(level.map.at({2, 0}), 0);
  level = ground_level({"r=7", "[#]", "L_J"});
  apply_edit(level, fill_ground(level, {0, 0, 3, 3}, GroundChange::remove, CellRect{0, 0, 3, 1}));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{"...", "[#]", "L_J"})) << "no other tiles below";
}

TEST(AutoTile, ALineFarBeyondTheMapIsCut) {
  Level level = ground_level({"...", "..."});
  apply_edit(level, paint_ground(level, {-2'000'000, 1}, {2'000'000, 1}, GroundChange::add));
  EXPECT_EQ(ground_rows(level.map), (GroundRows{"...", "==="}));
}

RC_GTEST_PROP(AutoTileProperty, TheOrderOfPaintingDoesNotMatter, ()) {
  const int width = *rc::gen::inRange(1, 12), height = *rc::gen::inRange(1, 8);
  Level start;
  start.auto_tiles = full_set();
  start.map = TileMap(width, height);
  const auto cells = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, width), rc::gen::inRange(0, height)));
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::uint32_t> keys =
      *rc::gen::container<std::vector<std::uint32_t>>(cells.size(), rc::gen::arbitrary<std::uint32_t>());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  Level first = start, second = start;
  for (const auto& [x, y] : cells) apply_edit(first, paint_ground(first, {x, y}, {x, y}, GroundChange::add));
  for (const std::size_t i : order) {
    const Cell cell{cells[i].first, cells[i].second};
    apply_edit(second, paint_ground(second, cell, cell, GroundChange::add));
  }
  RC_ASSERT(ground_rows(first.map) == ground_rows(second.map));
  // The result does not depend on earlier ground either.
  apply_edit(second, fill_ground(second, {0, 0, width, height}, GroundChange::add));
  for (Cell c{0, 0}; c.y < height; ++c.y) {
    for (c.x = 0; c.x < width; ++c.x)
      if (first.map.tile_at(c) == 0) apply_edit(second, paint_ground(second, c, c, GroundChange::remove));
  }
  RC_ASSERT(ground_rows(first.map) == ground_rows(second.map));
}

// --- The proposal

void draw_tile(Level& level, TileNumber tile, const std::vector<std::string>& rows) {
  TileImage& image = level.sheet(SheetId::tiles).images[tile];
  for (std::size_t i = 0; i < image.size(); ++i)
    image[i] = static_cast<std::uint8_t>(rows[i / kCartTileSize][i % kCartTileSize] - '0');
}

constexpr FlagSet kSolidFlag = 1, kUpFlag = 4, kDownFlag = 8;

// A sheet of brown ground (3) with grass (5) and dark sides (1), and grey rock (7) that comes first.
Level sheet_of_ground() {
  Level level;
  auto& flags = level.sheet(SheetId::tiles).flags;
  const std::vector<std::string> plain(8, "33333333");
  const auto with_edges = [&](bool top, bool left, bool right, bool bottom) {
    std::vector<std::string> rows = plain;
    for (std::string& row : rows) {
      if (left) row[0] = '1';
      if (right) row[7] = '1';
    }
    if (top) rows[0] = "55555555";
    if (bottom) rows[7] = "11111111";
    return rows;
  };
  for (int tile = 10; tile <= 18; ++tile) flags[static_cast<std::size_t>(tile)] = kSolidFlag;
  draw_tile(level, 10, with_edges(true, true, false, false));
  draw_tile(level, 11, with_edges(true, false, false, false));
  draw_tile(level, 12, with_edges(true, false, true, false));
  draw_tile(level, 13, with_edges(false, true, false, false));
  draw_tile(level, 14, plain);
  draw_tile(level, 15, with_edges(false, false, true, false));
  draw_tile(level, 16, with_edges(false, true, false, true));
  draw_tile(level, 17, with_edges(false, false, false, true));
  draw_tile(level, 18, with_edges(false, false, true, true));
  return level;
}

std::vector<TileNumber> all_tiles() {
  std::vector<TileNumber> tiles(kCartTiles);
  std::iota(tiles.begin(), tiles.end(), TileNumber{0});
  return tiles;
}

TEST(AutoTileProposal, RecognisesSidesAndCornersByTheirPixels) {
  AutoTiles expected;
  using enum GroundPart;
  expected.of(inside) = 14;
  expected.of(top_left) = 10;
  expected.of(top) = 11;
  expected.of(top_right) = 12;
  expected.of(left) = 13;
  expected.of(right) = 15;
  expected.of(bottom_left) = 16;
  expected.of(bottom) = 17;
  expected.of(bottom_right) = 18;
  EXPECT_EQ(proposed_auto_tiles(sheet_of_ground(), all_tiles()), expected);
}

// Draws a solid tile with a top edge of its own.
void draw_rock(Level& level, TileNumber tile, const std::string& row) {
  level.sheet(SheetId::tiles).flags[tile] = kSolidFlag;
  std::vector<std::string> rock(8, row);
  rock[0] = "66666666";
  draw_tile(level, tile, rock);
}

TEST(AutoTileProposal, TakesTheEdgesThatLookLikeTheInside) {
  Level level = sheet_of_ground();
  draw_rock(level, 5, "77777777");
  EXPECT_EQ(proposed_auto_tiles(level, all_tiles()).of(GroundPart::top), 11);
}

TEST(AutoTileProposal, LeavesOutEdgesOfOtherGround) {
  Level level = sheet_of_ground();
  level.sheet(SheetId::tiles).flags[11] = 0;  // this ground has no top,
  draw_rock(level, 5, "77777733");            // but rock has one, with some pixels in the ground's colour
  EXPECT_EQ(proposed_auto_tiles(level, all_tiles()).of(GroundPart::top), 0);
}

TEST(AutoTileProposal, TakesSlopesByTheirShapes) {
  Level level = sheet_of_ground();
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[20] = kUpFlag;  // as in the article, two tiles wide: 21 is its other half
  flags[22] = kDownFlag;
  level.tile_shapes[30] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[31] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  const AutoTiles set = proposed_auto_tiles(level, all_tiles());
  EXPECT_EQ(set.of(GroundPart::slope_up), 30);
  EXPECT_EQ(set.of(GroundPart::slope_down), 31);
  EXPECT_EQ(set.of(GroundPart::slope_up_left), 20);
  EXPECT_EQ(set.of(GroundPart::slope_up_right), 21);
  EXPECT_EQ(set.of(GroundPart::slope_down_left), 22);
  EXPECT_EQ(set.of(GroundPart::slope_down_right), 23);
}

TEST(AutoTileProposal, TakesHalvesThatHaveShapesOfTheirOwn) {
  Level level = sheet_of_ground();
  level.tile_shapes[40] = {.kind = TileShape::Kind::slope, .heights = {0, 4}};
  level.tile_shapes[41] = {.kind = TileShape::Kind::slope, .heights = {4, 8}};
  level.tile_shapes[42] = {.kind = TileShape::Kind::slope, .heights = {8, 4}};  // without its other half
  const AutoTiles set = proposed_auto_tiles(level, all_tiles());
  EXPECT_EQ(set.of(GroundPart::slope_up_left), 40);
  EXPECT_EQ(set.of(GroundPart::slope_up_right), 41);
  EXPECT_EQ(set.of(GroundPart::slope_down_left), 0);
  EXPECT_EQ(set.of(GroundPart::slope_down_right), 0);
}

TEST(AutoTileProposal, ChoosesOnlyAmongTheGivenTiles) {
  const Level level = sheet_of_ground();
  AutoTiles expected;
  expected.of(GroundPart::inside) = 11;  // there is no plain tile among them
  expected.of(GroundPart::top) = 11;
  EXPECT_EQ(proposed_auto_tiles(level, std::vector<TileNumber>{0, 11, 50}), expected);
  EXPECT_TRUE(proposed_auto_tiles(level, std::vector<TileNumber>{0, 50}).empty());
}

}  // namespace talus::auto_tile_test
