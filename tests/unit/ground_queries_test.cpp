// What games ask of the ground: floors, ceilings, lines of sight and overlaps.
#include "collision/ground_queries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <talus/level/tileset.h>
#include "reference/exact_ground.h"
#include "test_map.h"

namespace talus::ground_queries_test {

// Tile 2 rises from (8, 24) to (16, 16). The floor is at y = 24, and a tile hangs above it.
class GroundQueries : public testing::Test {
 protected:
  const Terrain ground_ = TestMap({"...1..", "......", ".2....", "111111"}).compile();
};

TEST_F(GroundQueries, FloorBelow) {
  const auto flat = floor_below(ground_, {25, 10, 4, 4}, 20);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->y, 24);
  EXPECT_EQ(flat->normal, (Vec2{0, -1}));
  EXPECT_EQ(flat->origin, 3 * 6 + 3);
  const auto slope = floor_below(ground_, {10, 8, 4, 4}, 20);
  ASSERT_TRUE(slope);
  EXPECT_EQ(slope->y, 18);  // under the right corner, at x = 14
  EXPECT_DOUBLE_EQ(slope->normal.x, -std::sqrt(0.5));
  EXPECT_EQ(slope->origin, 2 * 6 + 1);
  EXPECT_EQ(floor_below(ground_, {10, 8, 4, 4}, 20, Foot::centre)->y, 20);
}

TEST_F(GroundQueries, FloorBelowKeepsToTheAskedDistance) {
  EXPECT_EQ(floor_below(ground_, {24, 10, 4, 4}, 10)->y, 24);
  EXPECT_FALSE(floor_below(ground_, {24, 10, 4, 4}, std::nextafter(10.0, 0.0)));
  EXPECT_FALSE(floor_below(ground_, {24, 22, 4, 4}, 10)) << "inside of the ground";
}

TEST_F(GroundQueries, CeilingAbove) {
  const auto ceiling = ceiling_above(ground_, {26, 12, 4, 4}, 4);
  ASSERT_TRUE(ceiling);
  EXPECT_EQ(ceiling->y, 8);
  EXPECT_EQ(ceiling->normal, (Vec2{0, 1}));
  EXPECT_EQ(ceiling->origin, 3);
  EXPECT_FALSE(ceiling_above(ground_, {26, 12, 4, 4}, 3.5));
  EXPECT_FALSE(ceiling_above(ground_, {32, 12, 4, 4}, 100)) << "beside it";
}

TEST_F(GroundQueries, CastSegment) {
  const auto down = cast_segment(ground_, {12, 10}, {12, 30});
  ASSERT_TRUE(down);
  EXPECT_EQ(down->t, 0.5);
  EXPECT_EQ(down->position, (Vec2{12, 20}));
  const auto level = cast_segment(ground_, {20, 4}, {28, 4});
  ASSERT_TRUE(level);
  EXPECT_EQ(level->t, 0.5);
  EXPECT_EQ(level->position, (Vec2{24, 4}));
  EXPECT_EQ(level->normal, (Vec2{-1, 0}));
  EXPECT_FALSE(cast_segment(ground_, {0, 10}, {48, 10}));
  EXPECT_FALSE(cast_segment(ground_, {20, 4}, {20, 4}));
}

TEST_F(GroundQueries, OverlapsGround) {
  EXPECT_FALSE(overlaps_ground(ground_, Rect{24, 20, 4, 4})) << "on the floor";
  EXPECT_TRUE(overlaps_ground(ground_, Rect{24, 20.01, 4, 4}));
  EXPECT_FALSE(overlaps_ground(ground_, Rect{20, 4, 4, 4})) << "beside the tile";
  EXPECT_TRUE(overlaps_ground(ground_, Rect{20.01, 4, 4, 4}));
  EXPECT_FALSE(overlaps_ground(ground_, Rect{10, 14, 4, 4}));
  EXPECT_TRUE(overlaps_ground(ground_, Rect{10, 14.01, 4, 4}));
  EXPECT_FALSE(overlaps_ground(ground_, Rect{10, 16, 4, 4}, Foot::centre));
  EXPECT_TRUE(overlaps_ground(ground_, Rect{10, 16.01, 4, 4}, Foot::centre));
}

// A cast does not meet what a box is in: one that nothing leads out falls through all of the ground.
TEST(GroundQueriesInASlope, ABoxIsLedOutHoweverLittleItIsInIt) {
  const Terrain ground = TestMap({"....", ".2..", "1111"}).compile();  // from (8, 16) to (16, 8)
  for (const double depth : {1e-10, 1e-6, 0.002, 0.0039, 0.1}) {
    SCOPED_TRACE(depth);
    for (const auto& [foot, x] : {std::pair{Foot::centre, 8.0}, std::pair{Foot::box, 4.0}}) {
      EXPECT_FALSE(overlaps_ground(ground, {x, 4, 8, 8}, foot));
      const auto out = way_out(ground, {x, 4 + depth, 8, 8}, foot);
      ASSERT_TRUE(out);
      EXPECT_EQ(out->x, 0);
      EXPECT_DOUBLE_EQ(4 + depth + out->y, 4);
    }
  }
}

// Far from the origin, the floor of a slope is as exact as a double is at the largest coordinate.
TEST(GroundQueriesFarAway, FloorsOfSlopesAreExactToOneUnit) {
  using reference::Exact;
  constexpr int kColumn = 1250;  // x = 10000
  TestMap map(kColumn + 8, 4);
  map.cells[2 * map.width + kColumn] = kWide;  // (10000, 24) to (10024, 16)
  const Terrain ground = map.compile();
  reference::ExactGround exact;
  exact.parts.push_back({{10000, 24}, {10024, 16}, Exact(24), reference::Part::Stops::everywhere});
  const double ulp = std::nextafter(10024.0, 1e9) - 10024;
  for (int i = 0; i < 200; ++i) {
    const Rect box{10000.3 + i * 0.0731, 4, 5.3, 7.1};
    const Exact right = Exact(box.x) + Exact(box.w), middle = Exact(box.x) + Exact(box.w) / 2;
    const auto whole = floor_below(ground, box, 30), centre = floor_below(ground, box, 30, Foot::centre);
    ASSERT_TRUE(whole && centre) << i;
    EXPECT_LE(std::abs(Exact(Exact(whole->y) - *exact.floor_below(reference::ExactPoint{right, 0})).get_d()),
              ulp)
        << i;
    EXPECT_LE(
        std::abs(Exact(Exact(centre->y) - *exact.floor_below(reference::ExactPoint{middle, 0})).get_d()), ulp)
        << i;
  }
}

// Near a crest: the corner is in the tile behind the slope, and the centre is on the slope.
TEST(GroundQueriesByTheCentre, ACornerMayBeInTheTileBehindASlope) {
  const Terrain ground = TestMap({"....", ".21.", "1111"}).compile();
  const Rect box{10, 6, 8, 4};
  EXPECT_TRUE(overlaps_ground(ground, box, Foot::box));
  EXPECT_FALSE(overlaps_ground(ground, box, Foot::centre));
  EXPECT_EQ(floor_below(ground, box, 8, Foot::centre)->y, 10);
  EXPECT_FALSE(way_out(ground, box, Foot::centre));
  EXPECT_TRUE(overlaps_ground(ground, {13, 6, 8, 4}, Foot::centre)) << "the centre is in the tile";
}

// Its corner is in a tile that no slope leads to, and the shortest way out of that is below all tiles.
TEST(GroundQueriesByTheCentre, AWideBoxStaysOnItsSlope) {
  const Terrain ground = TestMap({"....211", "...2111", "..21111", "......."}).compile();
  EXPECT_TRUE(overlaps_ground(ground, {-8, 17, 56, 3}, Foot::centre));
  EXPECT_FALSE(way_out(ground, {-8, 17, 56, 3}, Foot::centre)) << "it stands on the slope";
  EXPECT_EQ(way_out(ground, {16, 22, 40, 3}, Foot::centre), (Vec2{0, 2})) << "its middle is in the ground";
}

// The tiles lead to slopes, so that the middle alone counts.
TEST(GroundQueriesByTheCentre, TheMiddleIsInTheGroundBetweenTwoTiles) {
  const Terrain ground = TestMap({".2..2.", "211211", "111111"}).compile();
  for (const double x : {4.0, 12.0, 20.0, 28.0})
    EXPECT_TRUE(overlaps_ground(ground, {x, 17, 8, 4}, Foot::centre)) << x;
  EXPECT_FALSE(overlaps_ground(TestMap({"....", ".21.", "...."}).compile(), {20, 9, 8, 4}, Foot::centre))
      << "on a wall";
}

TEST(GroundQueriesWithABudget, EndWhenItIsUsedUp) {
  TestMap map(140, 140);
  map.cells.assign(140 * 140, 1);
  const Terrain solid = map.compile();
  CastBudget budget{kMaxQueryWork};
  EXPECT_FALSE(way_out(solid, {40, 40, 1024, 1024}, Foot::box, &budget)) << "there is none";
  EXPECT_GT(budget.left, 0) << "enough for the largest bodies";
  budget.left = 100;
  EXPECT_FALSE(way_out(solid, {40, 40, 1024, 1024}, Foot::box, &budget));
  EXPECT_GE(budget.left, -100) << "the cells of a large box are counted, too";

  std::fill(map.cells.begin(), map.cells.end() - 140, TileNumber{0});
  const Terrain floor = map.compile();
  budget.left = kMaxQueryWork;
  EXPECT_TRUE(floor_below(floor, {40, 40, 8, 8}, 2000, Foot::box, &budget));
  budget.left = 10;
  EXPECT_FALSE(floor_below(floor, {40, 40, 8, 8}, 2000, Foot::box, &budget));
  EXPECT_FALSE(floor_below(floor, {40, 40, 8, 8}, 2000, Foot::box, &budget)) << "nothing is left";
}

TEST(GroundQueriesOfThinShapes, AShapeWithoutHeightIsNoGround) {
  TestMap map({"....", "...2", "...."});
  map.cells[5] = kFlat;
  EXPECT_FALSE(overlaps_ground(map.compile(), {9, 14, 4, 4}, Foot::box));
}

// A rising slope may have its body in other cells than its own, and reach over the map's edge.
TEST(GroundQueriesOfWideShapes, ABoxOverlapsThemFarFromTheirCell) {
  constexpr int kWidth = 14, kHeight = 11;
  struct Rising {
    TileNumber tile;
    int tiles;
    double height;  // px
  };
  constexpr std::array<Rising, 3> kRising = {{{kTall, 8, 64}, {kWide, 3, 8}, {kUp, 1, 8}}};
  std::mt19937 random(1);
  const auto in = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  int inside = 0, beyond = 0;
  Cell cell;
  Terrain ground;
  for (int i = 0; i < 20'000; ++i) {
    const Rising& rising = kRising[static_cast<std::size_t>(i / 10) % kRising.size()];
    if (i % 10 == 0) {
      cell = {static_cast<int>(in(0, kWidth)), static_cast<int>(in(0, kHeight))};
      TestMap map(kWidth, kHeight);
      map.cells[static_cast<std::size_t>(cell.y * kWidth + cell.x)] = rising.tile;
      ground = map.compile();
    }
    const Rect box{in(-40, 140), in(-40, 110), in(0.5, 20), in(0.5, 20)};
    const double left = cell.x * kCartTileSize, base = (cell.y + 1) * kCartTileSize;
    const double x = std::min(
        box.right(), left + rising.tiles * kCartTileSize);  // where the slope under the box is highest
    const double top = base - (x - left) * rising.height / (rising.tiles * kCartTileSize);
    const double deep = std::min({x - std::max(left, box.x), base - box.y, box.bottom() - top});
    if (std::abs(deep) < 0.01) continue;
    ASSERT_EQ(overlaps_ground(ground, box), deep > 0) << i;
    inside += deep > 0;
    beyond += deep > 0 && (box.x > kWidth * kCartTileSize || box.bottom() < 0);
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(beyond, 10);
}

}  // namespace talus::ground_queries_test
