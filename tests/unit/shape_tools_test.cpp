// The tool that lays slopes.
#include "edit/shape_tools.h"

#include <gtest/gtest.h>

#include "edit/snap.h"
#include "level/lint/lint.h"

namespace talus::shape_tools_test {

// Tile 1 is solid; 3 and 4 are the halves of the article's up-slope.
Level level_with_slopes() {
  Level level;
  level.map = TileMap(30, 17);
  Sheet& sheet = level.sheet(SheetId::tiles);
  for (int tile = 1; tile <= 4; ++tile) sheet.images[tile].fill(static_cast<std::uint8_t>(tile));
  sheet.flags[1] = 1;
  sheet.flags[3] = 4;
  return level;
}

Level after(Level level, const tl::expected<Edit, std::string>& edit) {
  apply_edit(level, edit.value());
  return level;
}

TEST(ShapeTools, SlopeUsesTheSlopesAndTheFullTileOfTheStamp) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {16, 40}, {32, 32}, {3, 1, {3, 4, 1}}, 12));
  EXPECT_EQ(laid.map.at({2, 4}), 3);
  EXPECT_EQ(laid.map.at({3, 4}), 4);
  EXPECT_EQ(laid.map.at({2, 5}), 1);
  EXPECT_TRUE(laid.sheets == level.sheets);
}

TEST(ShapeTools, SlopeInTrueColourTakesTheSlopesOfTheSheet) {
  Level level = level_with_slopes();
  EXPECT_FALSE(lay_slope(level, {16, 40}, {300, 32}, {1, 1, {1}}, 12)) << "it leaves the map";
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(
      SheetPicture{128, 128, std::vector<std::uint8_t>(std::size_t{4} * 128 * 128, 255)});
  const Level laid = after(level, lay_slope(level, {16, 40}, {32, 32}, {1, 1, {1}}, 12));
  EXPECT_EQ(laid.map.at({2, 4}), 3);
  EXPECT_EQ(laid.map.at({3, 4}), 4);
  level.sheet(SheetId::tiles).flags.assign(level.sheet(SheetId::tiles).flags.size(), 0);
  EXPECT_FALSE(lay_slope(level, {16, 40}, {32, 32}, {1, 1, {1}}, 12)) << "none can be drawn";
}

// The only slope rises by 8 px in a tile, so that the floor goes on level now and then.
TEST(ShapeTools, SlopesOfTheSheetNeverFallWhereTheLineRises) {
  Level level = level_with_slopes();
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.flags[3] = 0;
  level.tile_shapes[5] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[6] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  for (const double rise : {8.0, 16.0, 24.0}) {
    const Level laid = after(level, lay_slope(level, {16, 80}, {112, 80 - rise}, {3, 1, {5, 6, 1}}, 12));
    for (int x = 0; x < 30; ++x)
      for (int y = 0; y < 17; ++y) EXPECT_NE(laid.map.at({x, y}), 6) << rise << ": " << x << "," << y;
  }
}

TEST(ShapeTools, SlopeIsDrawnIfTheStampHasNone) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {32, 32}, {16, 40}, {1, 1, {1}}, 12));
  const TileNumber drawn = laid.map.tile_at({2, 4});
  EXPECT_EQ(drawn, 5) << "the first blank one";
  EXPECT_EQ(laid.tile_shapes[drawn], (TileShape{.kind = TileShape::Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(laid.sheet(SheetId::tiles).images[drawn][7 * 8 + 1], 12) << "its edge";
  EXPECT_EQ(laid.map.at({2, 5}), 1);
}

TEST(ShapeTools, ADrawnSlopeHasTheColoursOfTheGround) {
  Level level = level_with_slopes();
  level.sheet(SheetId::tiles).images[2].fill(7);
  std::fill_n(level.sheet(SheetId::tiles).images[2].begin(), 8, std::uint8_t{6});
  level.auto_tiles.of(GroundPart::inside) = 1;
  level.auto_tiles.of(GroundPart::top) = 2;
  const Level laid = after(level, lay_slope(level, {32, 32}, {16, 40}, {1, 1, {0}}, 12));
  const TileImage& image = laid.sheet(SheetId::tiles).images[laid.map.tile_at({2, 4})];
  EXPECT_EQ(image[7 * 8 + 1], 6) << "the edge: of the first row of the top";
  EXPECT_EQ(image[7 * 8 + 7], 1) << "below: of the inside";
}

TEST(ShapeTools, GroundThatASlopeCoversGetsThePartThatFits) {
  Level level = level_with_slopes();
  level.sheet(SheetId::tiles).flags[2] = 1;
  level.auto_tiles.of(GroundPart::inside) = 1;
  level.auto_tiles.of(GroundPart::top) = 2;
  for (int x = 0; x < 30; ++x) level.map.set({x, 6}, 2);
  level.map.set({3, 6}, MapCell(2, TileTurn::left_right));
  const auto slope = lay_slope(level, {16, 48}, {48, 32}, {1, 1, {0}}, 12);
  const Level laid = after(level, slope);
  EXPECT_EQ(laid.map.at({1, 6}), 2) << "beside it";
  EXPECT_EQ(laid.map.at({2, 6}), 1) << "under it";
  EXPECT_EQ(laid.map.at({3, 6}), MapCell(2, TileTurn::left_right)) << "turned by hand";
  Level undone = laid;
  revert_edit(undone, *slope);
  EXPECT_TRUE(undone.map == level.map);
  const Level unfilled = after(level, lay_slope(level, {16, 48}, {48, 32}, {1, 1, {0}}, 12, {}, false));
  EXPECT_EQ(unfilled.map.at({2, 6}), 2) << "only where the ground is filled";
}

// Grass on the ground, without auto-tiles: a hill has it on both sides, and none inside.
TEST(ShapeTools, AHillHasTheTopOfTheGroundThatItCovers) {
  Level level = level_with_slopes();
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.flags[2] = 1;
  std::fill_n(sheet.images[2].begin(), 8, std::uint8_t{6});  // its first row
  for (int x = 0; x < 30; ++x) {
    for (int y = 6; y < 17; ++y) level.map.set({x, y}, y == 6 && x < 10 ? 2 : 1);
  }
  level = after(level, lay_slope(level, {32, 48}, {56, 20}, {1, 1, {0}}, 12));
  level = after(level, lay_slope(level, {56, 20}, {80, 48}, {1, 1, {0}}, 12));
  for (int x = 3; x < 11; ++x) EXPECT_EQ(level.map.at({x, 6}), x < 4 ? 2 : 1) << x;
  for (const Cell cell : {Cell{4, 5}, Cell{9, 5}}) {
    const TileImage& image = level.sheet(SheetId::tiles).images[level.map.tile_at(cell)];
    EXPECT_GT(std::count(image.begin(), image.end(), 6), 0)
        << cell.x << ": the ground beside it may have none";
  }
}

TEST(ShapeTools, GroundFromWhichTheTopIsCutOffKeepsItsGrass) {
  Level level = level_with_slopes();
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.flags[1] = 0;
  sheet.flags[2] = sheet.flags[4] = 1;  // 2: the grass, 4: inside
  std::fill_n(sheet.images[2].begin(), 8, std::uint8_t{6});
  for (int x = 0; x < 30; ++x) {
    for (int y = 6; y < 17; ++y) level.map.set({x, y}, y == 6 ? 2 : 4);
  }
  level.map.set({5, 5}, 4);
  const Level laid = after(level, lay_slope(level, {32, 48}, {64, 48}, {1, 1, {0}}, 12));
  EXPECT_EQ(laid.map.at({5, 5}), 0);
  for (int x = 4; x < 8; ++x) EXPECT_EQ(laid.map.at({x, 6}), 2) << x;
}

TEST(ShapeTools, SlopeStaysInsideTheSelection) {
  const Level level = level_with_slopes();
  const CellRect selection{2, 0, 2, 17};
  const Level laid = after(level, lay_slope(level, {0, 48}, {64, 16}, {1, 1, {1}}, 12, selection));
  int shaped = 0, placed = 0;
  for (const TileShape& shape : laid.tile_shapes) shaped += shape.kind == TileShape::Kind::slope ? 1 : 0;
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 17; ++y) {
      if (laid.map.tile_at({x, y}) == 0) continue;
      EXPECT_TRUE(selection.contains({x, y})) << x << " " << y;
      placed += laid.map.tile_at({x, y}) != 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(placed, 2);
  EXPECT_GE(shaped, 1);
  EXPECT_LE(shaped, placed);
  const Edit nothing = lay_slope(level, {0, 48}, {64, 16}, {1, 1, {1}}, 12, CellRect{20, 0, 2, 2}).value();
  EXPECT_TRUE(nothing.empty());
}

int drawn_tiles(const Level& level) {
  int count = 0;
  for (const TileImage& image : level.sheet(SheetId::tiles).images) count += image != TileImage{} ? 1 : 0;
  return count;
}

// A floor of full tiles from row 12 down.
Level level_with_floor() {
  Level level = level_with_slopes();
  level.spawns.push_back({"hero", {4, 4}, {}, "", BodyKind::player, {8, 8}});
  for (int y = 12; y < 17; ++y)
    for (int x = 0; x < 30; ++x) level.map.set({x, y}, 1);
  return level;
}

TEST(ShapeTools, AHillOfTwoDragsIsFilled) {
  Level level = level_with_floor();
  const int before = drawn_tiles(level);
  // Ends near the floor, near the top of the first slope, and near the floor again.
  const Vec2 foot = snap_slope_end(level, {33, 95}, 2), top = snap_slope_end(level, {97.2, 64.4}, 2);
  level = after(level, lay_slope(level, foot, top, {}, 12));
  const Vec2 same_top = snap_slope_end(level, {95.6, 62.5}, 2), end = snap_slope_end(level, {159, 97.4}, 2);
  EXPECT_EQ(foot, (Vec2{32, 96}));
  EXPECT_EQ(same_top, top);
  EXPECT_EQ(end, (Vec2{160, 96}));
  level = after(level, lay_slope(level, same_top, end, {}, 12));
  EXPECT_TRUE(lint(level).empty()) << lint(level)[0].message;
  for (int x = 4; x < 20; ++x) {
    int y = 0;
    while (shape_of_tile(level, level.map.tile_at({x, y})).kind == TileShape::Kind::none) ++y;
    EXPECT_LT(y, 12) << x;
    for (++y; y < 17; ++y) EXPECT_EQ(level.map.at({x, y}), 1) << x << " " << y;
  }
  EXPECT_EQ(drawn_tiles(level), before + 4) << "two tiles up and two down";
}

// A hand lets go a little beside the end of the slope before, at any zoom.
TEST(ShapeTools, TheNextSlopeBeginsWhereTheOneBeforeEnds) {
  for (const double zoom : {1.0, 3.0, 8.0}) {
    for (const Vec2 off : {Vec2{3, -5}, Vec2{-5, -4}, Vec2{2, 6}, Vec2{-3, 3}}) {
      Level level = level_with_floor();
      const Vec2 foot = snap_slope_end(level, {33, 95}, zoom), top = snap_slope_end(level, {97, 69}, zoom);
      level = after(level, lay_slope(level, foot, top, {}, 12));
      EXPECT_EQ(snap_slope_end(level, top + off, zoom), top) << zoom << " " << off.x << "," << off.y;
    }
  }
}

// A hand lets go below the line of the floor.
TEST(ShapeTools, AnEndInsideTheGroundGoesUpToItsTop) {
  Level level = level_with_floor();
  for (const double y : {96.0, 99.0, 101.0, 104.0, 111.0, 130.0})
    EXPECT_EQ(snap_slope_end(level, {118, y}, 2), (Vec2{120, 96})) << y;
  for (int y = 12; y < 17; ++y) level.map.set({20, y}, 0);
  EXPECT_EQ(snap_slope_end(level, {161, 120}, 2), (Vec2{160, 120})) << "at the ground's side";
}

TEST(ShapeTools, SlopesThatMeetInATileAreOneFloor) {
  Level level = level_with_floor();
  level = after(level, lay_slope(level, {32, 96}, {77, 75}, {}, 12));
  level = after(level, lay_slope(level, {77, 75}, {120, 60}, {}, 12));
  for (const Problem& problem : lint(level))
    EXPECT_GE(problem.cell->x, 14) << problem.message << ", but not at the end in the air";
  const TileShape shape = level.tile_shapes[level.map.tile_at({9, 9})];
  ASSERT_EQ(shape.kind, TileShape::Kind::profile);
  EXPECT_NEAR(shape.heights.front(), 80 - (96 - 40.0 * 21 / 45), kSlopeTileGrain);
  EXPECT_NEAR(shape.heights.back(), 80 - (75 - 3.0 * 15 / 43), kSlopeTileGrain);
}

TEST(ShapeTools, SlopesMakeNoProblem) {
  for (int i = 0; i < 40; ++i) {  // lines of all kinds between snapped ends
    Level level = level_with_floor();
    Vec2 from = snap_slope_end(level, {i * 3.7, 96}, 2);
    for (int drag = 0; drag < 3; ++drag) {
      const Vec2 to = snap_slope_end(
          level, {from.x + 24 + (i * 7 + drag * 13) % 30, drag == 2 ? 95 : 96.0 - (i * 11 + drag * 29) % 40},
          2);
      const auto edit = lay_slope(level, from, to, {}, static_cast<std::uint8_t>(i % 16));
      if (!edit) continue;
      level = after(level, edit);
      from = to;
    }
    for (const Problem& problem : lint(level)) ADD_FAILURE() << i << ": " << problem.message;
  }
}

TEST(ShapeTools, BodiesThatASlopeWouldBuryStartAboveIt) {
  Level level = level_with_floor();
  const auto player = [](double x, double y) { return Spawn{"", {x, y}, {}, "", BodyKind::player, {8, 8}}; };
  level.spawns = {player(44, 88), player(4, 88), player(60, 100)};  // under it, beside it, in the ground
  const auto edit = lay_slope(level, {32, 96}, {64, 64}, {}, 12);
  const Level laid = after(level, edit);
  EXPECT_EQ(laid.spawns[0].position, (Vec2{44, 72})) << "on the slope, where its middle is";
  EXPECT_EQ(laid.spawns[1], level.spawns[1]);
  EXPECT_EQ(laid.spawns[2], level.spawns[2]);
  for (const Problem& problem : lint(laid)) EXPECT_EQ(problem.object, 2) << problem.message;
  Level undone = laid;
  revert_edit(undone, edit.value());
  EXPECT_TRUE(undone == level);
}

// Its middle is just beside the slope, and half of it would be in the ground under that.
TEST(ShapeTools, ABodyBesideASlopeStartsAboveIt) {
  Level level = level_with_floor();
  for (int y = 12; y < 17; ++y) level.map.set({1, y}, 0);
  level.spawns = {Spawn{"", {12, 88}, {}, "", BodyKind::player, {8, 8}, Foot::centre}};
  const Level laid = after(level, lay_slope(level, {16, 80}, {48, 56}, {}, 12));
  EXPECT_EQ(laid.spawns[0].position, (Vec2{12, 69}));
  EXPECT_TRUE(lint(laid).empty()) << lint(laid)[0].message;
}

TEST(ShapeTools, SlopesUseTilesWithTheSameShapeAgain) {
  Level level = level_with_floor();
  TileImage image{};
  for (int x = 0; x < 8; ++x)
    for (int y = 7 - x; y < 8; ++y) image[static_cast<std::size_t>(y * 8 + x)] = 7;
  level.sheet(SheetId::tiles).images[20] = image;
  level.tile_shapes[20] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  const Level laid = after(level, lay_slope(level, {32, 96}, {64, 64}, {}, 12));
  EXPECT_EQ(laid.map.at({4, 11}), 20);
  EXPECT_EQ(laid.map.at({7, 8}), 20);
  EXPECT_TRUE(laid.sheets == level.sheets) << "in the user's colours";
}

// The tiles of a steep slope reach into the cells above them, whose pictures are tiles of their own.
TEST(ShapeTools, ASteepSlopeThatIsLaidAgainStays) {
  for (const Vec2 end : {Vec2{64, 48}, Vec2{56, 60}, Vec2{32, 96}}) {
    const Vec2 from = end.x == 32 ? Vec2{64, 48} : Vec2{32, 96};
    const Level once = after(level_with_floor(), lay_slope(level_with_floor(), from, end, {}, 12));
    const Level again = after(once, lay_slope(once, from, end, {}, 12));
    EXPECT_TRUE(again.map == once.map) << end.x << "," << end.y;
    EXPECT_TRUE(again.sheets == once.sheets) << "no tile is drawn anew";
  }
}

TEST(ShapeTools, SlopeIsNotFilledIfTheUserWantsNone) {
  const Level level = level_with_floor();
  const Level laid = after(level, lay_slope(level, {32, 96}, {64, 64}, {}, 12, {}, false));
  EXPECT_EQ(laid.map.at({7, 10}), 0);
}

TEST(ShapeTools, SlopeTooSteepToStandOnIsRefused) {
  Level level = level_with_floor();
  level.tuning.solver = SolverKind::exact;
  level.tuning.exact.steepest = 2;
  EXPECT_EQ(
      lay_slope(level, {32, 96}, {40, 72}, {}, 12).error(),
      "the slope is too steep to stand on: it may rise by 2 px for each px (steepest floor, in Tuning)");
  EXPECT_TRUE(lay_slope(level, {32, 96}, {40, 80}, {}, 12));
}

TEST(ShapeTools, SlopeDeepInsideOfTheGroundIsNotLaid) {
  Level level = level_with_floor();
  for (int y = 0; y < 17; ++y)
    for (int x = 10; x < 20; ++x) level.map.set({x, y}, 1);
  EXPECT_EQ(lay_slope(level, {96, 120}, {120, 112}, {}, 12).error(), "the line is deep inside of the ground");
  const Level laid =
      after(level, lay_slope(level, {64, 96}, {96, 80}, {}, 12));  // up to the mountain, and in
  EXPECT_NE(laid.map.at({9, 11}), 0);
  EXPECT_EQ(laid.map.at({10, 10}), 1);
}

TEST(ShapeTools, SlopeThatCannotBeLaidSaysWhy) {
  Level level = level_with_slopes();
  EXPECT_EQ(lay_slope(level, {16, 40}, {16, 40}, {}, 12).error(), "drag from one end to the other");
  for (int tile = 1; tile < kCartTiles; ++tile) level.sheet(SheetId::tiles).images[tile].fill(3);
  EXPECT_EQ(lay_slope(level, {0, 8}, {8, 0}, {}, 12).error(),
            "there are too few blank tiles to draw the slope with");
}

}  // namespace talus::shape_tools_test
