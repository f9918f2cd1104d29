// The ground as a level gives it, which judges the solvers.
#include <gtest/gtest.h>

#include <vector>

#include "prove/raw_ground.h"
#include "test_map.h"

namespace talus::raw_ground_test {

std::vector<RawPart> parts_in(const RawGround& ground, const Rect& area) {
  std::vector<RawPart> parts;
  ground.for_parts(fine_box(area), [&](const RawPart& part) {
    parts.push_back(part);
    return true;
  });
  return parts;
}

bool is_free(const RawGround& ground, const Rect& box) {
  const FineBox inner = fine_box(box);
  return ground.for_parts(inner, [&](const RawPart& part) { return !part.meets(inner); });
}

TEST(RawGround, HasThePartsOfTilesWhereTheyAre) {
  const TestMap map({"...", ".2.", "111"});
  const RawGround ground(map.source());
  const auto parts = parts_in(ground, {8.5, 8.5, 7, 7});
  ASSERT_EQ(parts.size(), 1u) << "the floor below is not touched";
  EXPECT_EQ(parts[0].kind, RawPart::Kind::solid);
  EXPECT_EQ(parts[0].top.at(fine(8)), fine(16));
  EXPECT_EQ(parts[0].top.at(fine(10)), fine(14));
  EXPECT_EQ(parts[0].top.at(fine(16)), fine(8));
}

TEST(RawGround, SlopesAreMetExactly) {
  TestMap map({"...", "...", "111"});
  map.cells[3] = kWide;  // rises by 8 px over three tiles, a third of a px for each
  const RawGround ground(map.source());
  EXPECT_TRUE(is_free(ground, {1, 11, 2, 4}));
  EXPECT_TRUE(is_free(ground, {1, 11, 2, 4 - px_of(1)}));
  EXPECT_FALSE(is_free(ground, {1, 11, 2, 4 + px_of(1)})) << "by the smallest length that there is";
}

TEST(RawGround, LinesStopWhatComesFromTheirSide) {
  TestMap map({"...", "...", "111"});
  map.cells[4] = kPlatform;
  const RawGround ground(map.source());
  const auto parts = parts_in(ground, {9, 7, 6, 4});
  ASSERT_EQ(parts.size(), 1u);
  const RawPart& line = parts[0];
  EXPECT_EQ(line.kind, RawPart::Kind::floor);
  const FineBox above = fine_box({9, 2, 4, 6});
  EXPECT_TRUE(line.stops(above, above.moved(0, 1)));
  EXPECT_FALSE(line.stops(above.moved(0, kFinePx), above.moved(0, 2 * kFinePx))) << "it is behind it";
  const FineBox below = fine_box({9, 8, 4, 6});
  EXPECT_FALSE(line.stops(below, below.moved(0, -kFinePx)));
}

TEST(RawGround, PolygonsAreCutWhereTheirPointsAre) {
  TestMap map({"...", "...", "111"});
  TerrainSource source = map.source();
  TileShape star{.kind = TileShape::Kind::polygon};
  star.points = {{0, 0}, {4, 5}, {8, 0}, {8, 8}, {0, 8}};  // a valley
  source.shapes[kHill] = star;
  map.cells[4] = kHill;
  source.cells = map.cells;
  const RawGround ground(source);
  EXPECT_TRUE(is_free(ground, {11.5, 8, 1, 4}));
  EXPECT_FALSE(is_free(ground, {11.5, 8, 1, 5}));
  EXPECT_FALSE(is_free(ground, {8, 12, 2, 2}));
}

}  // namespace talus::raw_ground_test
