// Casts of boxes of every size, at every distance, and one bit below and above the limits.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include <talus/collision/cast.h>
#include <talus/sim/solver.h>
#include "level_picture.h"
#include "sim/exact_mover.h"
#include "test_map.h"

namespace talus::cast_scale_test {

using Others = std::span<const BasicRect<double>>;

Contact<double> cast_at(const Terrain& ground, const Cast<double>& cast, const Rect& other) {
  return cast_box<double>(ground, cast, Others(&other, 1));
}

// A scale by a power of two scales every place, and leaves the time as it is.
TEST(CastScale, BoxesScaledByPowersOfTwoMeetAtTheSameTime) {
  const Terrain empty = TestMap(1, 1).compile();
  const Rect box{-20.3, -11.7, 3.1, 2.9}, other{1.7, -4.3, 40.9, 30.1};
  const Vec2 motion{37.3, 11.9};
  const Contact<double> one = cast_at(empty, {box, motion}, other);
  ASSERT_TRUE(one);
  for (int k = 0; k <= 20; ++k) {
    const double s = std::exp2(k);
    const Contact<double> c = cast_at(empty, {{box.x * s, box.y * s, box.w * s, box.h * s}, motion * s},
                                      {other.x * s, other.y * s, other.w * s, other.h * s});
    EXPECT_EQ(c.t, one.t) << k;
    EXPECT_EQ(c.position, one.position * s) << k;
    EXPECT_EQ(c.normal, one.normal) << k;
  }
}

TEST(CastScale, BoxesOfEverySizeLandOnFloorsAndSlopes) {
  const Terrain ground = TestMap({"....", ".2..", "1111"}).compile();  // (8, 16) to (16, 8)
  for (const double side : {1e-9, 1e-6, 1e-3, 1.0 / 256, 1.0, 0.0}) {
    const Contact<double> floor = cast_box(ground, {{20, 4, side, side}, {0, 16}});
    ASSERT_TRUE(floor) << side;
    EXPECT_EQ(floor.position.y, 16 - side) << side;
    const Contact<double> slope = cast_box(ground, {{10, 4, side, side}, {0, 16}});
    ASSERT_TRUE(slope) << side;
    EXPECT_NEAR(slope.position.y, 14 - 2 * side, 0x1p-49) << side;
  }
}

TEST(CastScale, ABoxWithoutMotionMeetsNothing) {
  const Terrain ground = TestMap({"....", ".2..", "1111"}).compile();
  EXPECT_FALSE(cast_box(ground, {{20, 8, 8, 8}, {0, 0}}));
  EXPECT_FALSE(cast_box(ground, {{20, 16, 0, 0}, {0, 0}}));
  EXPECT_FALSE(cast_box(ground, {{12, 12, 0, 0}, {0, 0}}));
}

// A box that is pushed against a wall far away is put beside it to the bit, is not moved further, and can
// leave.
TEST(CastScale, PushesAndLeavesBoxesFarAway) {
  const Terrain empty = TestMap(1, 1).compile();
  for (const double at : {1e6, 1e7, -1e7}) {
    const Rect wall{at, at, 16, 64};
    const Contact<double> c = cast_at(empty, {{at - 10.3, at + 8, 8, 8}, {5.7, 0}}, wall);
    ASSERT_TRUE(c) << at;
    EXPECT_EQ(c.position, (Vec2{at - 8, at + 8}));
    EXPECT_EQ(c.normal, (Vec2{-1, 0}));
    const Rect there{c.position.x, c.position.y, 8, 8};
    EXPECT_EQ(cast_at(empty, {there, {2.3, 0}}, wall).t, 0) << at;
    EXPECT_EQ(cast_at(empty, {there, {2.3, 0}}, wall).position, c.position) << at;
    EXPECT_FALSE(cast_at(empty, {there, {-2.3, 0}}, wall)) << at;
  }
}

// ---- At the far ends of long and high maps ----

double ulp_of(double number) {
  return std::nextafter(number, std::numeric_limits<double>::infinity()) - number;
}

// Boxes fall diagonally onto a slope of 8 px in 24, whose low end is in the cell `at`. Contacts are exact to
// one unit in the last place of the larger coordinate. long double has enough digits to check this.
void expect_exact_casts(const Terrain& ground, Cell at, Vec2 origin) {
  using Wide = long double;
  const Wide x0 = at.x * Wide(kCartTileSize), y0 = (at.y + 1) * Wide(kCartTileSize);
  const double ulp = ulp_of(std::max(origin.x, origin.y));
  for (int i = 0; i < 200; ++i) {
    const Rect box{origin.x + i * 0.0625, origin.y + i % 7 * 0.125, 5 + i % 3 * 0.5, 6};
    const Vec2 motion{(i % 9 - 4) * 0.3125, 24.75};
    const Contact<double> c = cast_box(ground, {box, motion});
    ASSERT_TRUE(c) << i;
    // The lower right corner comes to y0 - (x - x0) / 3.
    const Wide corner_x = Wide(box.x) + box.w - x0, above = y0 - corner_x / 3 - (Wide(box.y) + box.h);
    const Wide t = above / (motion.y + Wide(motion.x) / 3);
    ASSERT_GT(t, 0);
    ASSERT_LT(t, 1);
    const Wide x = box.x + t * motion.x, y = box.y + t * motion.y;
    EXPECT_LE(std::abs(c.position.x - x), ulp) << i;
    EXPECT_LE(std::abs(c.position.y - y), ulp) << i;
  }
}

TEST(CastScale, ContactsAreExactAsFarAsMapsReach) {
  for (const int far : {1 << 10, 1 << 17, kMaxTerrainSide - 8}) {
    for (const bool is_long : {true, false}) {
      const Cell at = is_long ? Cell{far, 5} : Cell{2, far};
      TestMap map(at.x + 5, at.y + 2);
      map.cells[static_cast<std::size_t>(at.y) * map.width + at.x] = kWide;
      const Vec2 origin{at.x * 8.0 + 1.5, at.y * 8.0 - 14};
      expect_exact_casts(map.compile(), at, origin);
    }
  }
}

// ---- One bit below and above the limits ----

TEST(CastScale, TheSteepestWalkableSlopeIsComparedExactly) {
  const Terrain ground = TestMap({"....", ".2..", "1111"}).compile();
  const Contact<double> c = cast_box(ground, {{8, 2, 4, 4}, {0, 16}});
  ASSERT_TRUE(c.piece);
  EXPECT_TRUE(is_level(c, 1.0));
  EXPECT_TRUE(is_level(c, std::nextafter(1.0, 2.0)));
  EXPECT_FALSE(is_level(c, std::nextafter(1.0, 0.0)));
}

// A player walks off a ledge of 8 px. Is it on the lower floor as soon as it has left the ledge?
bool is_pulled_down(double snap) {
  Level level = level_of({"........", "........", "###.....", "########"});
  level.tuning.solver = SolverKind::exact;
  level.tuning.exact.snap = snap;
  Spawn player;
  player.kind = BodyKind::player;
  player.foot = Foot::box;
  player.position = {8, 8};
  level.spawns.push_back(player);
  const Scene scene = compile_scene(level);
  State state = initial_state(scene);
  Input right;
  right.right = true;
  while (state.bodies[0].box.x < 24) state = step(scene, state, right);
  return state.bodies[0].box.y == 16 && state.bodies[0].gait.grounded;
}

TEST(CastScale, TheSnapDistanceIsComparedExactly) {
  EXPECT_TRUE(is_pulled_down(8));
  EXPECT_TRUE(is_pulled_down(std::nextafter(8.0, 9.0)));
  EXPECT_FALSE(is_pulled_down(std::nextafter(8.0, 7.0)));
}

}  // namespace talus::cast_scale_test
