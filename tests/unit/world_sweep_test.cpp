// The contacts of a moving box: times, normals, touch points, overlaps, and their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <talus/collision/world.h>
#include "collision/sweep.h"

namespace talus::world_sweep_test {

using testing::ElementsAre;

constexpr auto kSlide = [](ItemId, ItemId) { return Response::slide; };

std::vector<Collision> project(const World& world, Rect rect, Vec2 goal) {
  std::vector<Collision> hits;
  world.project({}, rect, goal, kSlide, hits);
  return hits;
}

// The contacts of a mover at (0, 0, 8, 8) with one other box.
std::vector<Collision> contacts(Rect other, Vec2 goal) {
  World world;
  world.add(other);
  return project(world, {0, 0, 8, 8}, goal);
}

//   +--+          +--+
//   |  | -20-> 12 |  |      4/20 of the way is free
//   +--+          +--+
TEST(WorldSweep, ReportsTimeNormalAndTouch) {
  const auto hits = contacts({12, 0, 8, 8}, {20, 0});
  ASSERT_EQ(hits.size(), 1u);
  const Collision& hit = hits[0];
  EXPECT_FALSE(hit.overlaps);
  EXPECT_EQ(hit.ti, 0.2);
  EXPECT_EQ(hit.normal, (Vec2{-1, 0}));
  EXPECT_EQ(hit.touch, (Vec2{4, 0}));
  EXPECT_EQ(hit.move, (Vec2{20, 0}));
  EXPECT_EQ(hit.item, ItemId{});
  EXPECT_EQ(hit.item_rect, (Rect{0, 0, 8, 8}));
  EXPECT_EQ(hit.other_rect, (Rect{12, 0, 8, 8}));
  EXPECT_EQ(hit.response, Response::slide);
  EXPECT_FALSE(hit.aim);
}

TEST(WorldSweep, ReportsTheSideThatWasHit) {
  EXPECT_EQ(contacts({-20, 0, 8, 8}, {-20, 0}).at(0).normal, (Vec2{1, 0}));
  EXPECT_EQ(contacts({0, 20, 8, 8}, {0, 20}).at(0).normal, (Vec2{0, -1}));
  EXPECT_EQ(contacts({0, -20, 8, 8}, {0, -20}).at(0).normal, (Vec2{0, 1}));
}

//   +--+
//   |  |\             aimed corner to corner: the vertical side wins
//   +--+ \ +--+
//         \|  |
TEST(WorldSweep, GivesCornersToTheVerticalSide) {
  const auto hits = contacts({16, 16, 8, 8}, {24, 24});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].normal, (Vec2{-1, 0}));
  EXPECT_EQ(hits[0].ti, 8.0 / 24);
}

TEST(WorldSweep, PassesACornerThatItOnlyGrazes) {
  EXPECT_TRUE(contacts({8, -8, 8, 8}, {8, 8}).empty());
  EXPECT_TRUE(contacts({16, 0, 8, 8}, {16, 16}).empty());
}

//   +--++--+
//   |  ||  |  touching: pushing is a contact at time 0, sliding along and leaving are none
//   +--++--+
TEST(WorldSweep, MeetsATouchingBoxOnlyWhenItPushes) {
  const auto hits = contacts({8, 0, 8, 8}, {5, 0});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].ti, 0);
  EXPECT_TRUE(std::signbit(hits[0].ti));
  EXPECT_EQ(hits[0].touch, (Vec2{0, 0}));
  EXPECT_TRUE(contacts({8, 0, 8, 8}, {0, 5}).empty());
  EXPECT_TRUE(contacts({8, 0, 8, 8}, {-5, 0}).empty());
  EXPECT_TRUE(contacts({8, 0, 8, 8}, {0, 0}).empty());
}

TEST(WorldSweep, IgnoresAGoalThatExactlyTouches) {
  EXPECT_TRUE(contacts({12, 0, 8, 8}, {4, 0}).empty());
  EXPECT_EQ(contacts({12, 0, 8, 8}, {std::nextafter(4.0, 5.0), 0}).size(), 1u);
}

// The tolerance is 1e-10 of the move: at that depth a contact still counts, deeper it does not.
TEST(WorldSweep, ForgivesATinyOverlapInProportionToTheMove) {
  EXPECT_EQ(contacts({8 - 0.5e-10, 0, 8, 8}, {1, 0}).size(), 1u);
  EXPECT_TRUE(contacts({8 - 0.9e-10, 0, 8, 8}, {0.5, 0}).empty());
}

TEST(WorldSweep, NeverTunnels) {
  const auto hits = contacts({1000, 2, 0.001, 0.001}, {1e6, 0});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].ti, 992 / 1e6);
}

//   +----+
//   |  +-|---+     still: out by the shortest way, here 2 to the left
//   +--|-+   |
//      +-----+
TEST(WorldSweep, PushesAStillBoxOutOfAnOverlap) {
  const auto hits = contacts({6, 3, 8, 8}, {0, 0});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_TRUE(hits[0].overlaps);
  EXPECT_EQ(hits[0].ti, -2 * 5);
  EXPECT_EQ(hits[0].normal, (Vec2{-1, 0}));
  EXPECT_EQ(hits[0].touch, (Vec2{-2, 0}));
  const auto down = contacts({1, -6, 8, 8}, {0, 0});
  EXPECT_EQ(down.at(0).normal, (Vec2{0, 1}));
  EXPECT_EQ(down.at(0).touch, (Vec2{0, 2}));
}

TEST(WorldSweep, PushesFromTheExactCentreToTheFarSide) {
  const auto hits = contacts({0, 0, 8, 8}, {0, 0});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].ti, -64);
  EXPECT_EQ(hits[0].normal, (Vec2{0, 1}));
  EXPECT_EQ(hits[0].touch, (Vec2{0, 8}));
}

// A box that moves while it overlaps is put back along its motion, however far that is.
TEST(WorldSweep, PushesAMovingBoxBackAlongItsMotion) {
  const auto hits = contacts({6, 0, 8, 80}, {0, 4});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_TRUE(hits[0].overlaps);
  EXPECT_EQ(hits[0].ti, -2 * 8);
  EXPECT_EQ(hits[0].normal, (Vec2{0, -1}));
  EXPECT_EQ(hits[0].touch, (Vec2{0, -8}));
}

//      far +--+   near +--+     sorted by time, not by adding
TEST(WorldSweep, SortsContactsByTime) {
  World world;
  const ItemId far = world.add({40, 0, 8, 8});
  const ItemId near = world.add({20, 0, 8, 8});
  const auto hits = project(world, {0, 0, 8, 8}, {100, 0});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].other, near);
  EXPECT_EQ(hits[1].other, far);
}

//    +--+--+
//    |A |B |     both at the same time: the one whose centre is nearer to the mover's
//    +--+--+
//      ^+--+
TEST(WorldSweep, SortsEqualTimesByDistanceThenAge) {
  World world;
  const ItemId a = world.add({-6, -20, 8, 8});
  const ItemId b = world.add({2, -20, 8, 8});
  const auto hits = project(world, {0, 0, 8, 8}, {0, -20});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].ti, hits[1].ti);
  EXPECT_EQ(hits[0].other, b);

  const ItemId twin = world.add({-6, -20, 8, 8});
  world.remove(a);
  const ItemId younger = world.add({-6, -20, 8, 8});
  ASSERT_EQ(younger.index, a.index);
  const auto tied = project(world, {0, 0, 8, 8}, {0, -20});
  ASSERT_EQ(tied.size(), 3u);
  EXPECT_EQ(tied[1].other, twin);
  EXPECT_EQ(tied[2].other, younger);
}

TEST(WorldSweep, LeavesOutTheMoverItself) {
  World world;
  const ItemId self = world.add({0, 0, 8, 8});
  std::vector<Collision> hits;
  world.project(self, {0, 0, 8, 8}, {4, 4}, kSlide, hits);
  EXPECT_TRUE(hits.empty());
  world.project({}, {0, 0, 8, 8}, {4, 4}, kSlide, hits);
  EXPECT_EQ(hits.size(), 1u);
}

// A filter sees each item of the swept cells once, even an item that the box cannot meet.
TEST(WorldSweep, AsksTheFilterOnceForEveryCandidate) {
  World world(10);
  const ItemId mover = world.add({1, 1, 2, 2});
  const ItemId big = world.add({4, 4, 30, 30});
  const ItemId in_cell = world.add({6, 1, 1, 1});
  world.add({60, 60, 1, 1});
  std::vector<ItemId> asked;
  std::vector<Collision> hits;
  world.project(
      mover, {1, 1, 2, 2}, {1, 14},
      [&](ItemId item, ItemId other) {
        EXPECT_EQ(item, mover);
        asked.push_back(other);
        return Response::cross;
      },
      hits);
  EXPECT_THAT(asked, testing::UnorderedElementsAre(big, in_cell));
}

TEST(WorldSweep, RejectsEarlyOnlyItemsThatCannotBeHit) {
  EXPECT_TRUE(misses_axis(5, 9, 5));
  EXPECT_FALSE(misses_axis(std::nextafter(5.0, 0.0), 9, 5));
  EXPECT_TRUE(misses_axis(-9, -5, -5));
  EXPECT_FALSE(misses_axis(-9, std::nextafter(-5.0, 0.0), -5));
  EXPECT_TRUE(misses_axis(0, 9, 0));
  EXPECT_FALSE(misses_axis(-9, 0, 1));
  EXPECT_TRUE(misses_axis(-9, -1e-9, 1));
  EXPECT_TRUE(misses_axis(1e-9, 9, -1));
  EXPECT_FALSE(misses_axis(NAN, NAN, 1));
  EXPECT_FALSE(misses_axis(1, 2, NAN));
}

}  // namespace talus::world_sweep_test
