// The outline of the ground as polygons: exact on small maps, and the same ground as the solver's on random
// maps.
#include "export/ground_polygons.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision/ground_queries.h"
#include "property/random_ground.h"
#include "unit/test_map.h"

namespace talus::ground_polygons_test {

std::string text_of(const GroundPolygon& polygon) {
  std::string text = polygon.is_hole ? "hole" : "";
  for (const Vec2 p : polygon.points) {
    char point[80];
    std::snprintf(point, sizeof point, "%s%.17g,%.17g", text.empty() ? "" : " ", p.x, p.y);
    text += point;
  }
  return text;
}

std::vector<GroundPolygon> polygons_of(const TerrainSource& ground) {
  return ground_polygons(ground).value();
}

std::vector<std::string> polygons(const std::vector<std::string>& rows) {
  const TestMap map(rows);
  std::vector<std::string> texts;
  for (const GroundPolygon& polygon : polygons_of(map.source())) texts.push_back(text_of(polygon));
  return texts;
}

using Texts = std::vector<std::string>;

TEST(GroundPolygons, AnEmptyMapHasNoPolygons) { EXPECT_EQ(polygons({"..", ".."}), Texts{}); }

TEST(GroundPolygons, TilesAreMergedClockwiseFromTheLeft) {
  EXPECT_EQ(polygons({"...", ".11", "111"}), Texts{"0,16 8,16 8,8 24,8 24,24 0,24"});
}

TEST(GroundPolygons, AHoleGoesTheOtherWay) {
  EXPECT_EQ(polygons({"111", "1.1", "111"}), (Texts{"0,0 24,0 24,24 0,24", "hole 8,8 8,16 16,16 16,8"}));
}

TEST(GroundPolygons, TilesThatTouchInACornerStayApart) {
  EXPECT_EQ(polygons({"1.", ".1"}), (Texts{"0,0 8,0 8,8 0,8", "8,8 16,8 16,16 8,16"}));
}

TEST(GroundPolygons, WallsThatContinuePastACornerStayApart) {
  EXPECT_EQ(polygons({"22", "26", "11"}),
            (Texts{"0,8 8,0 8,8", "0,16 8,8 8,16 16,16 16,24 0,24", "8,8 16,0 16,16"}));
}

TEST(GroundPolygons, SlopesJoinTheTilesBeneath) {
  EXPECT_EQ(polygons({".23.", "1111"}), Texts{"0,8 8,8 16,0 24,8 32,8 32,16 0,16"});
}

TEST(GroundPolygons, OneSlopeOverSeveralTilesIsOneLine) {
  EXPECT_EQ(polygons({"....", "5...", "...1"}), (Texts{"0,16 24,8 24,16", "24,16 32,16 32,24 24,24"}));
}

TEST(GroundPolygons, SlopesOfOneTileEachOnOneLineAreOneLine) {
  EXPECT_EQ(polygons({"..2", ".21", "211"}), Texts{"0,24 24,0 24,24"});
}

TEST(GroundPolygons, AProfileHasItsCorners) { EXPECT_EQ(polygons({"4"}), Texts{"0,8 2,4 4,2 6,4 8,8"}); }

TEST(GroundPolygons, CeilingsHaveTheirBodyAbove) {
  EXPECT_EQ(polygons({"11", "6."}), Texts{"0,0 16,0 16,8 8,8 8,16 0,8"});
}

TEST(GroundPolygons, OneWayTilesAndFlatLinesAreLeftOut) { EXPECT_EQ(polygons({"7<"}), Texts{}); }

TEST(GroundPolygons, CrossingsOfLinesAreRoundedTo256ths) {
  TestMap map({"..", ".."});
  TerrainSource ground = map.source();
  ground.shapes[1] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {8, 0}};
  map.cells = {1, kUp, 0, 0};
  ground.cells = map.cells;
  ASSERT_EQ(polygons_of(ground).size(), 1U);
  EXPECT_EQ(text_of(polygons_of(ground)[0]), "0,0 10.66796875,5.33203125 16,0 16,8 0,8");
}

TEST(GroundPolygons, ShapesReachOverTheMapsEdge) { EXPECT_EQ(polygons({"5"}), Texts{"0,8 24,0 24,8"}); }

// How often the rings go around a point: 1 is inside, 0 is outside.
int winding(const std::vector<GroundPolygon>& polygons, Vec2 p) {
  int winding = 0;
  for (const GroundPolygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Vec2 a = polygon.points[i], b = polygon.points[(i + 1) % polygon.points.size()];
      if ((a.x <= p.x) == (b.x <= p.x)) continue;
      const double y = a.y + (b.y - a.y) * ((p.x - a.x) / (b.x - a.x));
      if (y < p.y) winding += a.x < b.x ? 1 : -1;
    }
  }
  return winding;
}

double distance(const std::vector<GroundPolygon>& polygons, Vec2 p) {
  double nearest = 1000;
  for (const GroundPolygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Vec2 a = polygon.points[i], along = polygon.points[(i + 1) % polygon.points.size()] - a;
      const double part = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
      const Vec2 off = p - (a + along * part);
      nearest = std::min(nearest, std::hypot(off.x, off.y));
    }
  }
  return nearest;
}

TEST(GroundPolygons, HoldExactlyThePointsInTheGround) {
  int inside = 0, outside = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    TestMap map(9, 7);
    for (TileNumber& cell : map.cells) cell = dice.one_in(2) ? static_cast<std::uint8_t>(dice.up_to(12)) : 0;
    const Terrain ground = map.compile();
    const std::vector<GroundPolygon> rings = polygons_of(map.source());
    for (int i = 0; i < 200; ++i) {
      const Vec2 p{dice.in(0, 72), dice.in(0, 56)};
      if (distance(rings, p) < 0.05) continue;
      const int expected = overlaps_ground(ground, {p.x - 0.01, p.y - 0.01, 0.02, 0.02}) ? 1 : 0;
      ASSERT_EQ(winding(rings, p), expected) << "seed " << seed << " at " << p.x << "," << p.y;
      ++(expected ? inside : outside);
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

// A profile of many heights has as many sides.
std::string error_of_profiles(int width, int height, std::size_t most_sides) {
  TestMap map(width, height);
  std::fill(map.cells.begin(), map.cells.end(), TileNumber{1});
  TerrainSource ground = map.source();
  ground.shapes[1] = {.kind = TileShape::Kind::profile};
  for (int i = 0; i < max_shape_heights(ground.tile); ++i)
    ground.shapes[1].heights.push_back(i % 2 == 0 ? 2 : 6);
  const auto polygons = ground_polygons(ground, most_sides);
  return polygons ? "" : polygons.error().message;
}

TEST(GroundPolygons, MoreSidesThanTheLimitAreRefused) {
  EXPECT_EQ(error_of_profiles(40, 4, 9000),
            "has ground with more than 9000 sides in its outline, the most that can be exported: join "
            "separate tiles, or make the map smaller");
  EXPECT_EQ(error_of_profiles(40, 4, kMaxGroundSides), "");
}

// A map of 4096x4096 separate tiles took 3 GB.
TEST(LargeGround, MillionsOfSidesAreRefused) {
  EXPECT_EQ(error_of_profiles(4096, 32, kMaxGroundSides),
            "has ground with more than 8388608 sides in its outline, the most that can be exported: join "
            "separate tiles, or make the map smaller");
}

// Lines whose boxes do not overlap are not compared: a column of 100000 slopes took minutes.
TEST(GroundPolygons, ATallColumnOfSlopesIsFast) {
  TestMap map(1, 100'000);
  std::fill(map.cells.begin(), map.cells.end(), TileNumber{1});
  TerrainSource ground = map.source();
  ground.shapes[1] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  EXPECT_EQ(polygons_of(ground).size(), 100'000u);
}

}  // namespace talus::ground_polygons_test
