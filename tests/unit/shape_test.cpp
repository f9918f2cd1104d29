// Invalid shapes and curves, each with the sentence that says why.
#include <talus/collision/shape.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <talus/collision/terrain.h>

namespace talus::shape_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string problem(const TileShape& shape) { return problem_of(shape, {8, 8}).value_or(""); }

template <class Form>
std::string problem(Form form) {
  return problem_of(Curve{std::move(form), Curve::Faces::up}).value_or("");
}

TileShape shape_of(TileShape::Kind kind, std::vector<double> heights, int tiles = 1) {
  return {.kind = kind, .tiles = tiles, .heights = std::move(heights)};
}

TEST(TileShape, ValidOnesHaveNoProblem) {
  EXPECT_EQ(problem(TileShape{}), "");
  EXPECT_EQ(problem(shape_of(TileShape::Kind::solid, {})), "");
  EXPECT_EQ(problem(shape_of(TileShape::Kind::slope, {0, 64}, 8)), "");
  EXPECT_EQ(problem(shape_of(TileShape::Kind::profile, {0, 8, 0})), "");
  EXPECT_EQ(problem(shape_of(TileShape::Kind::profile, std::vector<double>(65, 4.5))), "");
}

TEST(TileShape, ProblemsSayWhy) {
  using Kind = TileShape::Kind;
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, 8}, 0)), "must be 1 to 8 tiles wide");
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, 8}, 9)), "must be 1 to 8 tiles wide");
  EXPECT_EQ(problem(shape_of(Kind::solid, {8})), "has heights, which only a slope or a profile has");
  EXPECT_EQ(problem(shape_of(Kind::slope, {0})), "must have 2 heights");
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, 1, 2})), "must have 2 heights");
  EXPECT_EQ(problem(shape_of(Kind::profile, {0, 1})), "must have 3 to 65 heights");
  EXPECT_EQ(problem(shape_of(Kind::profile, std::vector<double>(66))), "must have 3 to 65 heights");
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, kNan})), "has a height that is not a number");
  EXPECT_EQ(problem(shape_of(Kind::slope, {-0.001, 8})), "has a height that is not from 0 to 64 px");
  EXPECT_EQ(problem(shape_of(Kind::profile, {0, 64.5, 0})), "has a height that is not from 0 to 64 px");
}

TEST(TileShape, LimitsGoWithTheSizeOfTiles) {
  using Kind = TileShape::Kind;
  const auto problem = [](const TileShape& shape, TileSize tile) {
    return problem_of(shape, tile).value_or("");
  };
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, 256}, 8), {16, 32}), "");
  EXPECT_EQ(problem(shape_of(Kind::slope, {0, 256.5}), {16, 32}),
            "has a height that is not from 0 to 256 px");
  EXPECT_EQ(problem(shape_of(Kind::profile, std::vector<double>(129, 4)), {16, 32}), "");
  EXPECT_EQ(problem(shape_of(Kind::profile, std::vector<double>(130, 4)), {16, 32}),
            "must have 3 to 129 heights");
}

TEST(TerrainSize, EndsAtTheFurthestCoordinate) {
  EXPECT_TRUE(is_terrain_size(1 << 21, 8));
  EXPECT_FALSE(is_terrain_size((1 << 21) + 1, 1));
  EXPECT_TRUE(is_terrain_size(1 << 20, 16, {16, 16}));
  EXPECT_FALSE(is_terrain_size((1 << 20) + 1, 1, {16, 16}));
  EXPECT_TRUE(is_terrain_size((1 << 20) + 1, 1, {8, 16}));
  EXPECT_TRUE(is_terrain_size(4096, 4096, {256, 256}));
  for (const TileSize size : {TileSize{0, 8}, {8, 0}, {257, 8}, {8, 257}, {-8, 8}})
    EXPECT_FALSE(is_terrain_size(1, 1, size)) << size.width << "x" << size.height;
}

TEST(Curve, ValidOnesHaveNoProblem) {
  EXPECT_EQ(problem(Segment{{0, 0}, {1, -5}}), "");
  EXPECT_EQ(problem(Segment{{4, 1}, {4, 2}}), "");
  EXPECT_EQ(problem(Arc{{0, 0}, 64, -64, 64, true}), "");
  EXPECT_EQ(problem(Parabola{{0, 0}, {8, 0}, -8}), "");
  EXPECT_EQ(problem(Cubic{{0, 0}, {8, 0}, 3, -3}), "");
  EXPECT_EQ(problem(Sine{0, 640, 8, -8, 64, 3}), "");
  EXPECT_EQ(problem(Polyline{0, 8, {1, 2}}), "");
  EXPECT_EQ(problem(Segment{{-kMaxCoordinate, 0}, {kMaxCoordinate, 0}}), "");
}

TEST(Curve, NumbersMustBeFinite) {
  const std::string why = "has a number that is not finite";
  EXPECT_EQ(problem(Segment{{0, kNan}, {1, 0}}), why);
  EXPECT_EQ(problem(Arc{{0, 0}, kInfinity, -64, 64, true}), why);
  EXPECT_EQ(problem(Parabola{{0, 0}, {8, 0}, kNan}), why);
  EXPECT_EQ(problem(Cubic{{0, 0}, {8, 0}, kInfinity, 0}), why);
  EXPECT_EQ(problem(Sine{0, 8, 0, 0, kNan, 0}), why);
  EXPECT_EQ(problem(Polyline{0, 8, {1, kNan}}), why);
}

TEST(Curve, EndsMustBeInOrder) {
  const std::string zero = "has a width of zero", turned = "has its right end left of its left end";
  EXPECT_EQ(problem(Segment{{3, 3}, {3, 3}}), "has a length of zero");
  EXPECT_EQ(problem(Segment{{4, 3}, {3, 3}}), turned);
  EXPECT_EQ(problem(Segment{{3, 4}, {3, 3}}), "is vertical and has its lower end above its upper end");
  EXPECT_EQ(problem(Arc{{0, 0}, 8, 2, 2, true}), zero);
  EXPECT_EQ(problem(Parabola{{8, 0}, {0, 0}, 0}), turned);
  EXPECT_EQ(problem(Cubic{{8, 0}, {8, 4}, 0, 0}), zero);
  EXPECT_EQ(problem(Sine{8, 0, 0, 1, 8, 0}), turned);
  EXPECT_EQ(problem(Polyline{8, 8, {1, 2}}), zero);
}

TEST(Curve, ACurveThatRoundsToNothingIsInvalid) {
  const std::string why = "has a width of zero when rounded to 1/256 px";
  EXPECT_EQ(problem(Segment{{8, 8}, {8.0001, 8}}), "has a length of zero when rounded to 1/256 px");
  EXPECT_EQ(problem(Segment{{8, 8}, {8, 8.0001}}), "has a length of zero when rounded to 1/256 px");
  EXPECT_EQ(problem(Segment{{80, 104}, {80.001, 40}}), "");
  EXPECT_EQ(problem(Arc{{8, 8}, 8, 8, 8.001, true}), why);
  EXPECT_EQ(problem(Arc{{8, 8}, 0.0015, 7.999, 8.001, true}), why);
  EXPECT_EQ(problem(Arc{{8.0019, 8}, 8.0019, 16.001, 16.003, true}), "");  // 1/256 px wide, beyond its circle
  EXPECT_EQ(problem(Parabola{{8, 8}, {8.001, 40}, 8}), why);
  EXPECT_EQ(problem(Cubic{{8, 8}, {8.001, 40}, 0, 0}), why);
  EXPECT_EQ(problem(Sine{8, 8.001, 8, 4, 8, 0}), why);
  EXPECT_EQ(problem(Polyline{8, 8.001, {8, 40}}), why);
  EXPECT_EQ(problem(Parabola{{8, 8}, {8.003, 40}, 8}), "");  // 1/256 px wide
}

TEST(Curve, EachKindHasItsOwnLimits) {
  EXPECT_EQ(problem(Arc{{0, 0}, 0, -1, 1, true}), "has a radius that is not above zero");
  EXPECT_EQ(problem(Arc{{0, 0}, 8, -8.001, 8, true}), "has an end beyond its circle");
  EXPECT_EQ(problem(Arc{{0, 0}, 8, -8, 8.001, true}), "has an end beyond its circle");
  EXPECT_EQ(problem(Sine{0, 8, 0, 1, 0, 0}), "has a wavelength that is not above zero");
  EXPECT_EQ(problem(Sine{0, 4096, 0, 1, 1, 0}), "");
  EXPECT_EQ(problem(Sine{0, 4097, 0, 1, 1, 0}), "has more than 4096 waves");
  EXPECT_EQ(problem(Polyline{0, 8, {1}}), "needs at least 2 heights");
  EXPECT_EQ(problem(Polyline{0, 8, std::vector<double>(65537)}), "has more than 65536 heights");
  EXPECT_EQ(problem(Polyline{0, 8, std::vector<double>(2049)}), "");
  EXPECT_EQ(problem(Polyline{0, 8, std::vector<double>(2050)}),
            "has its heights closer to one another than 1/256 px");
}

TEST(Curve, NothingReachesTooFar) {
  const std::string why = "reaches further than 16777216 px from the origin";
  constexpr double kFar = kMaxCoordinate;
  EXPECT_EQ(problem(Segment{{0, 0}, {kFar + 1, 0}}), why);
  EXPECT_EQ(problem(Arc{{0, 8 - kFar}, 9, -1, 1, true}), why);
  EXPECT_EQ(problem(Arc{{0, 8 - kFar}, 9, -1, 1, false}), "");
  EXPECT_EQ(problem(Parabola{{0, 0}, {8, 0}, kFar + 1}), why);
  EXPECT_EQ(problem(Cubic{{0, 0}, {3, 0}, kFar + 1, 0}), why);
  EXPECT_EQ(problem(Sine{0, 8, kFar, 1, 8, 0}), why);
  EXPECT_EQ(problem(Polyline{0, 8, {1, -kFar - 1}}), why);
}

// The number of cells that pieces of a curve lie in. A terrain keeps one piece for each.
TEST(CellsPassed, AreCloseToThoseOfTheTerrain) {
  const std::vector<double> zigzag = {100, 400, 100, 400, 100};
  const auto up = [](auto form) { return Curve{form, Curve::Faces::up}; };
  for (const Curve& curve :
       {up(Segment{{10, 10}, {500, 500}}), up(Segment{{20, 10}, {20, 500}}),
        up(Arc{{256, 400}, 200, 60, 450}), up(Arc{{256, 400}, 200, 300, 450}),
        up(Parabola{{10, 300}, {500, 310}, 20}), up(Cubic{{10, 300}, {500, 310}, -3, 2}),
        up(Sine{10, 500, 256, 200, 40, 3}), up(Sine{10, 500, 256, 200, 4000, 3}),
        up(Polyline{10, 500, zigzag}), Curve{Polyline{10, 500, zigzag}, Curve::Faces::both}}) {
    const std::vector<TileNumber> cells(64 * 64);
    TerrainSource source;
    source.width = source.height = 64;
    source.cells = cells;
    source.curves = {curve};
    const Terrain terrain(source);
    double pieces = 0;
    for (Cell c; c.y < 64; ++c.y)
      for (c.x = 0; c.x < 64; ++c.x) pieces += static_cast<double>(terrain.pieces_in(c).size());
    EXPECT_GT(cells_passed(curve, {}), pieces / 2) << curve.form.index();
    EXPECT_LT(cells_passed(curve, {}), pieces * 2) << curve.form.index();
  }
}

}  // namespace talus::shape_test
