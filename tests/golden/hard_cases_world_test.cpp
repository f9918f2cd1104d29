// The hard cases that no level can show, in World itself. Its faithful mode fails them as bump.lua does,
// which is a reference. Its robust mode passes those about places and sensors.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <talus/collision/world.h>

namespace talus::hard_cases_world_test {

using testing::IsEmpty;

constexpr World::Mode kModes[] = {World::Mode::faithful, World::Mode::robust};

// Case 18: a goal that exactly touches.
TEST(HardCasesOfWorld, IgnoreATouchAtTheEnd) {
  World world;
  world.add({20, 0, 8, 8});
  const ItemId ball = world.add({0, 0, 8, 8});
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {12, 0}, hits), (Vec2{12, 0}));
  EXPECT_THAT(hits, IsEmpty());
}

// Case 20: (0, 0, 1, 1) moves to (3, 3), past (2, 2, 1, 1), and likewise in the other three directions.
TEST(HardCasesOfWorld, LetXWinAtACorner) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      World world;
      const ItemId ball = world.add({0, 0, 1, 1});
      world.add({2 * x, 2 * y, 1, 1});
      std::vector<Collision> hits;
      EXPECT_EQ(world.move(ball, {3 * x, 3 * y}, hits), (Vec2{x, 3 * y}));
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_EQ(hits[0].normal, (Vec2{-x, 0}));
    }
  }
}

// Case 21: x + w equals the ledge's x in doubles, and is a little larger in exact arithmetic.
TEST(HardCasesOfWorld, HangOnTheEdgeOfALedge) {
  World world;
  world.add({80, 40, 24, 32});
  const ItemId box = world.add({72.7, 30, 7.3, 8});
  ASSERT_EQ(72.7 + 7.3, 80);
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(box, {72.7, 60}, hits), (Vec2{72.7, 32}));
}

// Pushes 1000 boxes against a wall near (scale, scale) and away again. Returns how many of them end at a
// wrong place.
int teleports(World::Mode mode, double scale) {
  int count = 0;
  std::vector<Collision> hits;
  for (int i = 0; i < 1000; ++i) {
    World world(64, mode);
    const double x = scale * (1 + i / 1009.0), y = scale;
    world.add({x, y, 16, 64});
    const ItemId box = world.add({x - 30, y + 20, 12 + i / 1013.0, 14});
    const Vec2 pushed = world.move(box, Vec2{x - 5, y + 20}, hits);
    const Vec2 goal = pushed + Vec2{-3, 0};
    count += world.move(box, goal, hits) != goal;
  }
  return count;
}

// Case 23, from 1 to 10,000,000 px.
TEST(HardCasesOfWorld, TeleportFarAwayIfFaithful) {
  for (const double scale : {1.0, 1e2, 1e4, 1e5, 1e6, 1e7})
    EXPECT_EQ(teleports(World::Mode::robust, scale), 0) << scale;
  for (const double scale : {1.0, 1e2, 1e4}) EXPECT_EQ(teleports(World::Mode::faithful, scale), 0) << scale;
  EXPECT_GT(teleports(World::Mode::faithful, 1e6), 10);
  EXPECT_GT(teleports(World::Mode::faithful, 1e7), 200);
}

// Case 24: an overlap of a quarter of a box. Scaled down, it is smaller than the tolerance of 1e-10 px.
TEST(HardCasesOfWorld, HideOverlapsBelowTheTolerance) {
  const auto meets = [](double scale) {
    World world(64 * scale);
    world.add({6 * scale, 0, 8 * scale, 8 * scale});
    const ItemId box = world.add({0, 0, 8 * scale, 8 * scale});
    std::vector<Collision> hits;
    world.move(box, {0, scale}, hits);
    return !hits.empty();
  };
  EXPECT_TRUE(meets(1));
  EXPECT_TRUE(meets(std::exp2(20)));
  EXPECT_FALSE(meets(std::exp2(-40)));
}

// Case 25.
TEST(HardCasesOfWorld, RefuseInfinityAndPutNanIntoNoCell) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Collision> hits;
  for (const World::Mode mode : kModes) {
    World world(64, mode);
    const ItemId ball = world.add({0, 0, 8, 8});
    for (const double width : {0.0, -1.0, infinity}) EXPECT_THROW(world.add({0, 0, width, 8}), WorldError);
    EXPECT_THROW(world.move(ball, {infinity, 0}, hits), WorldError);
    EXPECT_EQ(world.rect(ball), (Rect{0, 0, 8, 8}));
    EXPECT_EQ(world.item_count(), 1u);
  }
  World robust(64, World::Mode::robust), faithful;
  EXPECT_THROW(robust.add({nan, 0, 8, 8}), WorldError);
  const ItemId lost = faithful.add({0, 0, 8, 8});
  EXPECT_TRUE(std::isnan(faithful.move(lost, {nan, 0}, hits).x));
  std::vector<ItemId> found;
  faithful.query_rect({-100, -100, 200, 200}, found);
  EXPECT_THAT(found, IsEmpty());
}

// Case 31: a box lands in the middle of the seam of two tiles. The end is always the same, the first contact
// is not.
TEST(HardCasesOfWorld, NameTheTileThatWasAddedFirst) {
  for (const double first : {0.0, 8.0}) {
    World world;
    const ItemId tile = world.add({first, 20, 8, 8});
    world.add({8 - first, 20, 8, 8});
    const ItemId box = world.add({4, 0, 8, 8});
    std::vector<Collision> hits;
    EXPECT_EQ(world.move(box, {4, 20}, hits), (Vec2{4, 12}));
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits[0].other, tile);
  }
}

// Case 33: the shaft of the file, with a sensor for the slope.
TEST(HardCasesOfWorld, BendAPathThroughASensorIfFaithful) {
  for (const World::Mode mode : kModes) {
    for (const bool sensor : {false, true}) {
      World world(64, mode);
      world.add({24, 0, 8, 96});
      world.add({8, 96, 8, 8});
      const ItemId zone = sensor ? world.add({16, 96, 16, 8}) : ItemId();
      const ItemId ball = world.add({8, 64, 8, 8});
      std::vector<Collision> hits;
      const Vec2 end = world.move(
          ball, {24, 90},
          [&](ItemId, ItemId other) { return other == zone ? Response::cross : Response::slide; }, hits);
      const bool bends = sensor && mode == World::Mode::faithful;
      EXPECT_EQ(end, (Vec2{16, bends ? 88.0 : 90.0}));
    }
  }
}

}  // namespace talus::hard_cases_world_test
