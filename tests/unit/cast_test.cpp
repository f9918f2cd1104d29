// Boxes cast against every kind of ground: when, where and with which normal it stops them.
#include <talus/collision/cast.h>

#include <gtest/gtest.h>

#include <cmath>

#include "test_map.h"

namespace talus::cast_test {

constexpr double kRoot2 = 0.70710678118654752440;  // half of the root of 2

Contact<double> cast(const Terrain& ground, Rect box, Vec2 motion, Foot foot = Foot::box) {
  return cast_box(ground, Cast<double>{box, motion, foot});
}

void expect_contact(const Contact<double>& c, double t, Vec2 position, Vec2 normal) {
  ASSERT_TRUE(c);
  EXPECT_EQ(c.t, t);
  EXPECT_EQ(c.position.x, position.x);
  EXPECT_EQ(c.position.y, position.y);
  EXPECT_DOUBLE_EQ(c.normal.x, normal.x);
  EXPECT_DOUBLE_EQ(c.normal.y, normal.y);
}

Terrain with_curve(Curve curve) {
  TestMap map(16, 16);
  map.curves = {std::move(curve)};
  return map.compile();
}

// ---- Full tiles ----

class CastTiles : public testing::Test {
 protected:
  const Terrain ground_ = TestMap({".....", ".....", "..1..", ".....", "....."}).compile();  // 16..24
};

TEST_F(CastTiles, EachSideStops) {
  expect_contact(cast(ground_, {18, 4, 4, 4}, {0, 16}), 0.5, {18, 12}, {0, -1});
  expect_contact(cast(ground_, {18, 32, 4, 4}, {0, -16}), 0.5, {18, 24}, {0, 1});
  expect_contact(cast(ground_, {4, 18, 4, 4}, {16, 0}), 0.5, {12, 18}, {-1, 0});
  expect_contact(cast(ground_, {32, 18, 4, 4}, {-16, 0}), 0.5, {24, 18}, {1, 0});
}

TEST_F(CastTiles, AMotionThatEndsBeforeTheTileIsFree) {
  EXPECT_FALSE(cast(ground_, {18, 4, 4, 4}, {0, 7}));
  EXPECT_FALSE(cast(ground_, {18, 4, 4, 4}, {0, 0}));
  EXPECT_FALSE(cast(ground_, {4, 4, 4, 4}, {32, 0}));
  EXPECT_FALSE(cast(ground_, {-1000, -1000, 4, 4}, {-50, 0}));
}

TEST_F(CastTiles, AMotionThatEndsAtATouchIsStopped) {
  expect_contact(cast(ground_, {18, 4, 4, 4}, {0, 8}), 1, {18, 12}, {0, -1});
  expect_contact(cast(ground_, {4, 18, 4, 4}, {8, 0}), 1, {12, 18}, {-1, 0});
}

TEST_F(CastTiles, ATouchingTileBlocksOnlyPushes) {
  expect_contact(cast(ground_, {18, 12, 4, 4}, {3, 1}), 0, {18, 12}, {0, -1});
  EXPECT_FALSE(cast(ground_, {18, 12, 4, 4}, {3, 0}));
  EXPECT_FALSE(cast(ground_, {18, 12, 4, 4}, {3, -1}));
  expect_contact(cast(ground_, {12, 18, 4, 4}, {1, 3}), 0, {12, 18}, {-1, 0});
  EXPECT_FALSE(cast(ground_, {12, 18, 4, 4}, {0, 30}));
}

TEST_F(CastTiles, ABoxBesideALedgeFalls) {
  EXPECT_FALSE(cast(ground_, {12, 4, 4, 4}, {0, 100}));
  EXPECT_FALSE(cast(ground_, {24, 4, 4, 4}, {0, 100}));
  EXPECT_TRUE(cast(ground_, {12.001, 4, 4, 4}, {0, 100}));
}

TEST_F(CastTiles, ACornerAimedAtExactlyIsAFloorOrACeiling) {
  expect_contact(cast(ground_, {8, 8, 4, 4}, {8, 8}), 0.5, {12, 12}, {0, -1});
  expect_contact(cast(ground_, {28, 8, 4, 4}, {-8, 8}), 0.5, {24, 12}, {0, -1});
  expect_contact(cast(ground_, {8, 28, 4, 4}, {8, -8}), 0.5, {12, 24}, {0, 1});
  expect_contact(cast(ground_, {28, 28, 4, 4}, {-8, -8}), 0.5, {24, 24}, {0, 1});
}

// A wall and the floor or ceiling at its end each let a box pass that is off the corner by rounding. Never do
// both.
TEST_F(CastTiles, NoRoundingLetsABoxIntoACorner) {
  constexpr double kUlp = 0x1p-48;  // of the coordinates from 16 to 32
  for (int off = 0; off < 200; ++off) {
    const double beside = 24 + off * kUlp, before = 12 - off * kUlp;
    EXPECT_TRUE(cast(ground_, {beside, 24, 4, 4}, {-0.125, -0.125})) << off;
    EXPECT_TRUE(cast(ground_, {beside, 12, 4, 4}, {-0.125, 0.125})) << off;
    EXPECT_TRUE(cast(ground_, {before, 24, 4, 4}, {0.125, -0.125})) << off;
    EXPECT_TRUE(cast(ground_, {before, 12, 4, 4}, {0.125, 0.125})) << off;
  }
}

// A box that comes into a corner meets wall and floor at the same time, and both face it equally. The more
// level contact counts, whichever is tested first.
TEST(CastCorners, TheMoreLevelOfTwoSimultaneousContactsCounts) {
  const Terrain right =
      TestMap({"....1", "....1", "....1", "11111"}).compile();  // the wall at 32, the floor at 24
  expect_contact(cast(right, {16, 8, 4, 4}, {16, 16}), 0.75, {28, 20}, {0, -1});
  const Terrain left = TestMap({"1....", "1....", "1....", "11111"}).compile();
  expect_contact(cast(left, {20, 8, 4, 4}, {-16, 16}), 0.75, {8, 20}, {0, -1});
  const Terrain above = TestMap({"11111", "....1", "....1", "....1"}).compile();  // the ceiling at 8
  expect_contact(cast(above, {16, 20, 4, 4}, {16, -16}), 0.75, {28, 8}, {0, 1});
}

TEST_F(CastTiles, ABoxLargerThanATile) {
  expect_contact(cast(ground_, {-30, -84, 100, 60}, {0, 80}), 0.5, {-30, -44}, {0, -1});
  expect_contact(cast(ground_, {-88, -30, 64, 100}, {80, 0}), 0.5, {-48, -30}, {-1, 0});
}

TEST_F(CastTiles, APointAndALine) {
  expect_contact(cast(ground_, {20, 8, 0, 0}, {0, 16}), 0.5, {20, 16}, {0, -1});
  expect_contact(cast(ground_, {8, 20, 0, 0}, {16, 0}), 0.5, {16, 20}, {-1, 0});
  expect_contact(cast(ground_, {18, 8, 4, 0}, {0, 16}), 0.5, {18, 16}, {0, -1});
}

TEST_F(CastTiles, TheGroundDoesNotStopABoxInsideIt) {
  EXPECT_FALSE(cast(ground_, {18, 18, 4, 4}, {0, 1}));
  EXPECT_FALSE(cast(ground_, {14, 18, 4, 4}, {1, 0}));
}

TEST_F(CastTiles, LongMotionsAreStopped) {
  const Contact<double> down = cast(ground_, {20, -499992, 8, 8}, {0, 1e6});
  expect_contact(down, 0.5, {20, 8}, {0, -1});
  expect_contact(cast(ground_, {500024, 18, 4, 4}, {-1e6, 0}), 0.5, {24, 18}, {1, 0});
  EXPECT_FALSE(cast(ground_, {-500000, -500000, 2, 2}, {1e6, 1e6 + 100}));
}

TEST(Cast, SeamsDoNotStopABox) {
  const Terrain floor = TestMap({"..........", "..........", "1111111111"}).compile();
  for (int i = 0; i < 64; ++i) EXPECT_FALSE(cast(floor, {0.1 + i, 8, 8, 8}, {7.3, 0}));
  const Terrain wall = TestMap({"..1", "..1", "..1", "..1", "..1", "..1"}).compile();
  for (int i = 0; i < 30; ++i) {
    expect_contact(cast(wall, {8, 0.1 + i, 8, 8}, {3, 5.7}), 0, {8, 0.1 + i}, {-1, 0});
    EXPECT_FALSE(cast(wall, {8, 0.1 + i, 8, 8}, {0, 5.7}));
  }
}

TEST(Cast, SeamsLetNothingThrough) {
  const Terrain floor = TestMap({"....", "....", "1111"}).compile();
  expect_contact(cast(floor, {8, 8, 0, 0}, {0, 16}), 0.5, {8, 16}, {0, -1});
  const Terrain hill = TestMap({"....", ".23.", "1111"}).compile();
  expect_contact(cast(hill, {16, 0, 0, 0}, {0, 16}), 0.5, {16, 8}, {0, -1});
  expect_contact(cast(hill, {8, 8, 0, 0}, {0, 16}), 0.5, {8, 16}, {0, -1});
}

TEST(Cast, TilesBeyondAWordOrAChunkStop) {
  TestMap map(130, 3);
  map.cells[2 * 130 + 64] = map.cells[2 * 130 + 63] = kSolid;
  map.cells[130 + 127] = map.cells[130 + 128] = kSolid;
  const Terrain ground = map.compile();
  expect_contact(cast(ground, {500, 0, 24, 8}, {0, 16}), 0.5, {500, 8}, {0, -1});
  expect_contact(cast(ground, {8, 9, 6, 6}, {2000, 0}), 0.501, {1010, 9}, {-1, 0});
  expect_contact(cast(ground, {-100, -8, 1300, 8}, {0, 16}), 0.5, {-100, 0}, {0, -1});
}

TEST(Cast, OtherBoxesStopAsTilesDo) {
  const Terrain ground = TestMap(4, 4).compile();
  const std::array<Rect, 2> others = {Rect{20, 0, 4, 4}, Rect{10, 0, 4, 4}};
  const auto c = cast_box<double>(ground, {{0, 0, 4, 4}, {12, 0}}, others);
  expect_contact(c, 0.5, {6, 0}, {-1, 0});
  EXPECT_TRUE(c.is_other);
  EXPECT_EQ(c.origin, -2);
}

// ---- Slopes ----

class CastSlopes : public testing::Test {
 protected:
  // Up from (8, 24) to (16, 16), then down to (24, 24).
  const Terrain ground_ = TestMap({".....", ".....", ".23..", "11111"}).compile();
};

TEST_F(CastSlopes, TheCornerStandsOnTheLine) {
  expect_contact(cast(ground_, {6, 12, 4, 4}, {0, 8}), 0.75, {6, 18}, {-kRoot2, -kRoot2});
  expect_contact(cast(ground_, {22, 12, 4, 4}, {0, 8}), 0.75, {22, 18}, {kRoot2, -kRoot2});
  expect_contact(cast(ground_, {0, 19, 4, 4}, {8, 0}), 0.625, {5, 19}, {-kRoot2, -kRoot2});
}

TEST_F(CastSlopes, TheBottomStandsOnACrest) {
  const Contact<double> c = cast(ground_, {14, 4, 4, 4}, {0, 16});
  expect_contact(c, 0.5, {14, 12}, {0, -1});
  EXPECT_TRUE(c.on_end);
  expect_contact(cast(ground_, {12, 4, 4, 4}, {0, 16}), 0.5, {12, 12}, {0, -1});
}

TEST_F(CastSlopes, TheCentreFootStandsOnTheLineByItsMiddle) {
  expect_contact(cast(ground_, {8, 12, 4, 4}, {0, 16}, Foot::centre), 0.375, {8, 18}, {-kRoot2, -kRoot2});
  expect_contact(cast(ground_, {14, 4, 4, 4}, {0, 16}, Foot::centre), 0.5, {14, 12}, {0, -1});
}

TEST_F(CastSlopes, ABoxGoesFromTheFloorOntoTheSlopeAndBack) {
  expect_contact(cast(ground_, {0, 20, 4, 4}, {8, 0}), 0.5, {4, 20}, {-kRoot2, -kRoot2});
  EXPECT_FALSE(cast(ground_, {28, 20, 4, 4}, {8, 0}));
  EXPECT_FALSE(cast(ground_, {4, 20, 4, 4}, {8, -8}));  // along it
  EXPECT_FALSE(cast(ground_, {4, 20, 4, 4}, {-4, 0}));  // down from its foot
}

TEST(Cast, TheBottomStandsOnTheEdgeOfAFloor) {
  const Terrain ground = TestMap({"...", "..2", "...", "..."}).compile();  // (16,16) to (24,8), open beside
  expect_contact(cast(ground, {22, -4, 8, 8}, {0, 8}), 0.5, {22, 0}, {0, -1});
  expect_contact(cast(ground, {22, -4, 8, 8}, {0, 8}, Foot::centre), 0.5, {22, 0}, {0, -1});
  EXPECT_FALSE(cast(ground, {24, -4, 8, 8}, {0, 80}));
  expect_contact(cast(ground, {8, 12, 4, 8}, {8, 0}), 0.5, {12, 12}, {-1, 0});  // the tip
}

TEST(Cast, ATipInsideOfACellStops) {
  TestMap map(4, 4);
  map.cells[5] = kTail;  // from (8,8) down to (12,16), and empty from there to (16,16)
  const Terrain ground = map.compile();
  expect_contact(cast(ground, {20, 12, 8, 8}, {-16, 0}), 0.5, {12, 12}, {1, 0});
  EXPECT_FALSE(cast(ground, {20, 16, 8, 8}, {-16, 0}));
}

TEST(Cast, TheNormalBetweenTwoSlopesPointsStraightUp) {
  const Terrain valley = TestMap({"....", ".32.", "1111"}).compile();  // deepest at (16,16)
  expect_contact(cast(valley, {12, -4, 8, 8}, {0, 16}), 0.5, {12, 4}, {0, -1});
}

// A box is one rounding short of the bottom of a notch, and moves almost straight down. It does not reach the
// other side before it has passed this one.
TEST(Cast, NothingSlipsThroughTheBottomOfANotch) {
  const Terrain valley = TestMap({"....", ".32.", "1111"}).compile();  // deepest at (16,16)
  const double short_by = 0x1p-44;
  for (const double side : {-1, 1}) {
    const Rect box{14 + side * short_by, 12 - short_by, 4, 4};
    const Contact<double> c = cast(valley, box, {side * -0.01, 1}, Foot::centre);
    expect_contact(c, 0, box.position(), {side * -kRoot2, -kRoot2});
  }
}

// The bottom of the wall is below (16, 8), where the slope ends.
TEST(Cast, AWallBehindASlopeStopsTheCentreFoot) {
  const Terrain ground = TestMap({"..1", ".21", "111"}).compile();
  expect_contact(cast(ground, {6, 13, 8, 1}, {16, -16}, Foot::centre), 0.375, {12, 7}, {-1, 0});
  expect_contact(cast(ground, {6, 10, 8, 4}, {16, -16}, Foot::centre), 0.125, {8, 8}, {-1, 0});
  const Terrain mirrored = TestMap({"1..", "13.", "111"}).compile();
  expect_contact(cast(mirrored, {10, 13, 8, 1}, {-16, -16}, Foot::centre), 0.375, {4, 7}, {1, 0});
}

// On a line that is steeper than 45 degrees, the contact's x is computed from the line. A y computed from it
// would be off by many roundings, and the box would be in the floor that it stands on.
TEST(Cast, ASteepLineDoesNotPushBoxesIntoTheFloor) {
  TestMap map({"....", "....", "....", "....", "1111"});
  map.curves = {{Segment{{21.0546875, 21.8125}, {21.75390625, 31}}, Curve::Faces::down}};
  const Terrain ground = map.compile();
  Rect box{15.1875, 28.9375, 5.75, 3.0625};
  const Contact<double> meets = cast(ground, box, {0.75, 0});
  ASSERT_TRUE(meets);
  EXPECT_EQ(meets.position.y, box.y);
  box.x = meets.position.x;
  const Contact<double> pushes = cast(ground, box, {0.25, 0});
  ASSERT_TRUE(pushes);
  EXPECT_DOUBLE_EQ(pushes.position.x, box.x);
  EXPECT_EQ(pushes.position.y, box.y);
}

// The box comes closer to the line, or the wall, so slowly that one rounding of the distance is worth
// thousands of its motions. Either it is at the floor, or it is not there yet.
TEST(Cast, RoundingDoesNotDecideWhatIsMetFirst) {
  TestMap map({"..1.", "..1.", "1111", "1111"});
  const Terrain wall = map.compile();
  map.cells[2] = map.cells[6] = 0;
  map.curves = {{Segment{{2, 8}, {30, 20}}, Curve::Faces::up}};
  const Terrain line = map.compile();
  for (int i = 1; i <= 100; ++i) {
    const double size = i * 0.03;
    const auto by_line = cast(line, {26 / 3.0, 76 / 7.0 - size - 0.75e-6, 8, size}, {16, 48 / 7.0 + 1e-6});
    ASSERT_TRUE(by_line);
    EXPECT_LE(by_line.position.y + size, 16 + 0x1p-47) << i;
    const auto by_wall = cast(wall, {16 - size - 0.75e-6, 4 - size, size, size}, {1e-6, 16});
    ASSERT_TRUE(by_wall);
    EXPECT_LE(by_wall.position.y + size, 16 + 0x1p-47) << i;
  }
}

TEST(Cast, CeilingsAreFloorsUpsideDown) {
  const Terrain ground = TestMap({"111", ".6.", "...", "..."}).compile();  // (8,8) to (16,16)
  expect_contact(cast(ground, {8, 20, 4, 4}, {0, -16}), 0.5, {8, 12}, {kRoot2 * -1, kRoot2});
  expect_contact(cast(ground, {14, 20, 4, 4}, {0, -8}), 0.5, {14, 16}, {0, 1});
}

TEST(Cast, ProfilesMayBeSteepAndFlat) {
  const Terrain ground = TestMap({"...", "...", ".4.", "111"}).compile();  // (8,24) 20 18 20 (16,24)
  expect_contact(cast(ground, {11, 6, 2, 4}, {0, 16}), 0.5, {11, 14}, {0, -1});
  const Contact<double> c = cast(ground, {4, 12, 5, 4}, {0, 12});
  expect_contact(c, 0.5, {4, 18}, {-2 / std::sqrt(5), -1 / std::sqrt(5)});
}

TEST(Cast, AnIgnoredPieceStopsNothing) {
  const Terrain ground = with_curve({Segment{{17, 28}, {23, 28}}, Curve::Faces::up});
  const Cast<double> fall{{16, 12, 8, 8}, {0, 16}};
  const Contact<double> c = cast_box(ground, fall);
  ASSERT_TRUE(c.piece);
  EXPECT_FALSE((cast_box<double>(ground, fall, {}, c.piece)));
}

// ---- One-way ----

TEST(Cast, OneWayTilesStopOnlyFromAbove) {
  const Terrain ground = TestMap({"....", "....", ".77.", "....", "...."}).compile();  // y = 16
  expect_contact(cast(ground, {10, 4, 4, 4}, {0, 16}), 0.5, {10, 12}, {0, -1});
  EXPECT_FALSE(cast(ground, {10, 30, 4, 4}, {0, -30}));
  EXPECT_FALSE(cast(ground, {0, 14, 4, 4}, {30, 0}));
  EXPECT_FALSE(cast(ground, {10, 14, 4, 4}, {0, 16}));  // half way through it
  EXPECT_TRUE(cast(ground, {10, 12, 4, 4}, {5, 0.5}));
}

// ---- Curves ----

TEST(CastCurves, AnArcStopsWhereItsCircleIs) {
  const Terrain hill = with_curve({Arc{{64, 80}, 50, 24, 104, true}, Curve::Faces::up});
  expect_contact(cast(hill, {60, 14, 8, 8}, {0, 16}), 0.5, {60, 22}, {0, -1});
  // The corner (34, y) meets (34, 40): 30-40-50.
  expect_contact(cast(hill, {26, 24, 8, 8}, {0, 16}), 0.5, {26, 32}, {-0.6, -0.8});
  expect_contact(cast(hill, {94, 24, 8, 8}, {0, 16}), 0.5, {94, 32}, {0.6, -0.8});
  EXPECT_FALSE(cast(hill, {60, 90, 8, 8}, {0, -90}));
  const Terrain bowl = with_curve({Arc{{64, 20}, 50, 14, 114, false}, Curve::Faces::up});
  expect_contact(cast(bowl, {24, 34, 10, 8}, {0, 16}), 0.5, {24, 42}, {0.8, -0.6});
}

TEST(CastCurves, AParabola) {
  // y = 32 + (x - 64)^2 / 32
  const Terrain hill = with_curve({Parabola{{32, 64}, {96, 64}, 0}, Curve::Faces::both});
  expect_contact(cast(hill, {60, 16, 8, 8}, {0, 16}), 0.5, {60, 24}, {0, -1});
  expect_contact(cast(hill, {40, 26, 8, 8}, {0, 12}), 0.5, {40, 32}, {-kRoot2, -kRoot2});
  expect_contact(cast(hill, {64, 64, 16, 8}, {0, -48}), 0.5, {64, 40}, {-kRoot2, kRoot2});
  expect_contact(cast(hill, {64, 64, 4, 8}, {0, -64}), 0.4921875, {64, 32.5},
                 {-0.24253562503633297, 0.97014250014533188});
}

TEST(CastCurves, ACubic) {
  // From (0,64) to (64,64) with slopes 1 and 1: y = 64 + u - 3u^2/64 + 2u^3/4096
  const Terrain wave = with_curve({Cubic{{0, 64}, {64, 64}, 1, 1}, Curve::Faces::up});
  const Contact<double> c = cast(wave, {32, 40, 8, 8}, {0, 32});
  ASSERT_TRUE(c);
  EXPECT_NEAR(c.position.y + 8, 64 + 40 - 3 * 25.0 + 2 * 64000.0 / 4096, 1e-13);
  EXPECT_EQ(cast(wave, {24, 40, 8, 8}, {0, 32}).position.y, 56);
}

TEST(CastCurves, ASine) {
  const Terrain waves = with_curve({Sine{8, 104, 64, 8, 32, 8}, Curve::Faces::up});  // crest at 32, y = 56
  expect_contact(cast(waves, {28, 40, 8, 8}, {0, 16}), 0.5, {28, 48}, {0, -1});
  const Contact<double> c = cast(waves, {12, 40, 8, 8}, {0, 32});  // right corner at x = 20: sin(3 pi / 4)
  ASSERT_TRUE(c);
  EXPECT_NEAR(c.position.y, 56 + 8 * kRoot2, 1e-13);
  // Across a trough, symmetrically: both corners at once.
  EXPECT_EQ(cast(waves, {44, 40, 8, 8}, {0, 40}).normal, (Vec2{0, -1}));
}

TEST(CastCurves, ACurveThatFacesDownStopsFromBelow) {
  const Terrain roof = with_curve({Segment{{16, 32}, {48, 32}}, Curve::Faces::down});
  expect_contact(cast(roof, {24, 48, 8, 8}, {0, -32}), 0.5, {24, 32}, {0, 1});
  EXPECT_FALSE(cast(roof, {24, 8, 8, 8}, {0, 64}));
}

TEST(CastCurves, ACurveThatFacesBothSidesStopsAtItsEnds) {
  const Terrain line = with_curve({Segment{{32, 32}, {64, 32}}, Curve::Faces::both});
  expect_contact(cast(line, {16, 28, 8, 8}, {16, 0}), 0.5, {24, 28}, {-1, 0});
  expect_contact(cast(line, {72, 28, 8, 8}, {-16, 0}), 0.5, {64, 28}, {1, 0});
  EXPECT_FALSE(cast(line, {16, 24, 8, 8}, {80, 0}));
  const Terrain pole = with_curve({Segment{{32, 32}, {32, 64}}, Curve::Faces::both});
  expect_contact(cast(pole, {28, 16, 8, 8}, {0, 16}), 0.5, {28, 24}, {0, -1});
  expect_contact(cast(pole, {28, 72, 8, 8}, {0, -16}), 0.5, {28, 64}, {0, 1});
  expect_contact(cast(pole, {28, 16, 8, 8}, {0, 16}, Foot::centre), 0.5, {28, 24}, {0, -1});
  expect_contact(cast(pole, {16, 40, 8, 8}, {16, 0}), 0.5, {24, 40}, {-1, 0});
  EXPECT_FALSE(cast(pole, {24, 16, 8, 8}, {0, 80}));
}

TEST(CastCurves, UprightSegmentsStopOnTheirSideOnly) {
  const Terrain left = with_curve({Segment{{32, 32}, {32, 64}}, Curve::Faces::up});
  EXPECT_TRUE(cast(left, {16, 40, 8, 8}, {16, 0}));
  EXPECT_FALSE(cast(left, {40, 40, 8, 8}, {-16, 0}));
}

// 80.001 is 80 when rounded to 1/256 px. The line rises to the right, so its upper side is its left side.
TEST(CastCurves, SegmentsRoundedUprightKeepTheirSide) {
  using Faces = Curve::Faces;
  const Segment rising{{80, 104}, {80.001, 40}}, falling{{80, 40}, {80.001, 104}}, pole{{80, 40}, {80, 104}};
  const auto stops = [](Segment segment, Faces faces, bool from_left) {
    const Terrain ground = with_curve({segment, faces});
    const Contact<double> c =
        from_left ? cast(ground, {60, 60, 8, 8}, {24, 0}) : cast(ground, {92, 60, 8, 8}, {-24, 0});
    if (c) expect_contact(c, 0.5, {from_left ? 72.0 : 80.0, 60}, {from_left ? -1.0 : 1.0, 0});
    return static_cast<bool>(c);
  };
  for (const bool from_left : {true, false}) {
    EXPECT_TRUE(stops(rising, Faces::both, from_left));
    EXPECT_TRUE(stops(falling, Faces::both, from_left));
    EXPECT_EQ(stops(rising, Faces::up, from_left), from_left);
    EXPECT_EQ(stops(rising, Faces::down, from_left), !from_left);
    EXPECT_EQ(stops(falling, Faces::up, from_left), !from_left);
    EXPECT_EQ(stops(falling, Faces::down, from_left), from_left);
    EXPECT_EQ(stops(pole, Faces::up, from_left), from_left);
    EXPECT_EQ(stops(pole, Faces::down, from_left), !from_left);
  }
}

TEST(CastCurves, APolylineIsJoinedAtItsHeights) {
  const Terrain line = with_curve({Polyline{16, 48, {64, 48, 64}}, Curve::Faces::up});
  expect_contact(cast(line, {28, 32, 8, 8}, {0, 16}), 0.5, {28, 40}, {0, -1});
  expect_contact(cast(line, {32, 24, 0, 0}, {0, 48}), 0.5, {32, 48}, {0, -1});
}

TEST(CastCurves, ALongMotionMeetsAThinLine) {
  const Terrain line = with_curve({Segment{{0, 64}, {128, 64}}, Curve::Faces::both});
  expect_contact(cast(line, {60, -499944, 8, 8}, {0, 1e6}), 0.5, {60, 56}, {0, -1});
}

TEST(Cast, CastsWorkInSinglePrecision) {
  TerrainSource source;
  source.width = source.height = 4;
  const std::vector<TileNumber> cells = {0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 1, 1, 1, 1};
  source.cells = cells;
  source.shapes = test_shapes();
  const BasicTerrain<float> ground(source);
  const auto c = cast_box<float>(ground, {{6, 12, 4, 4}, {0, 8}});
  EXPECT_EQ(c.t, 0.75f);
  EXPECT_EQ(c.position, (BasicVec2<float>{6, 18}));
}

}  // namespace talus::cast_test
