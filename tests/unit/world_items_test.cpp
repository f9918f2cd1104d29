// Items of a World: adding, placing, removing, handles, cells and the texts of errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <talus/collision/world.h>

namespace talus::world_items_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const WorldError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<ItemId> all_items(const World& world) {
  std::vector<ItemId> items;
  world.items(items);
  return items;
}

std::vector<ItemId> in_rect(const World& world, Rect rect) {
  std::vector<ItemId> items;
  world.query_rect(rect, items);
  return items;
}

TEST(WorldItems, KeepWhatTheyWereAddedWith) {
  World world;
  EXPECT_EQ(world.cell_size(), 64);
  EXPECT_EQ(world.item_count(), 0u);
  const ItemId a = world.add({1, 2, 3, 4});
  EXPECT_TRUE(a);
  EXPECT_EQ(a.index, 1u);
  EXPECT_TRUE(world.has(a));
  EXPECT_EQ(world.rect(a), (Rect{1, 2, 3, 4}));
  EXPECT_EQ(world.item_count(), 1u);
}

TEST(WorldItems, AreListedInTheOrderOfAdding) {
  World world;
  const ItemId a = world.add({0, 0, 1, 1});
  const ItemId b = world.add({2, 0, 1, 1});
  const ItemId c = world.add({4, 0, 1, 1});
  world.remove(a);
  const ItemId d = world.add({6, 0, 1, 1});
  EXPECT_EQ(d.index, a.index);
  EXPECT_THAT(all_items(world), ElementsAre(b, c, d));
  EXPECT_THAT(in_rect(world, {-1, -1, 20, 20}), ElementsAre(b, c, d));
}

TEST(WorldItems, AStaleOrNullHandleIsRefused) {
  World world;
  const ItemId a = world.add({0, 0, 1, 1});
  world.remove(a);
  const ItemId b = world.add({5, 5, 1, 1});
  ASSERT_EQ(a.index, b.index);
  EXPECT_NE(a.generation, b.generation);
  EXPECT_FALSE(world.has(a));
  EXPECT_FALSE(world.has({}));
  EXPECT_FALSE(world.has({7, 1}));
  const std::string sentence =
      "Item 1 must be added to the world before getting its rect. Use world:add(item, x,y,w,h) to add it "
      "first.";
  std::vector<Collision> hits;
  EXPECT_EQ(error_of([&] { world.rect(a); }), sentence);
  EXPECT_EQ(error_of([&] { world.remove(a); }), sentence);
  EXPECT_EQ(error_of([&] { world.update(a, Vec2{1, 1}); }), sentence);
  EXPECT_EQ(error_of([&] { world.update(a, Rect{1, 1, 1, 1}); }), sentence);
  EXPECT_EQ(error_of([&] { world.move(a, {1, 1}, hits); }), sentence);
  EXPECT_EQ(error_of([&] { world.rect({}); }).substr(0, 7), "Item 0 ");
  EXPECT_EQ(world.rect(b), (Rect{5, 5, 1, 1}));
}

TEST(WorldItems, MustHaveAPositiveSize) {
  World world;
  EXPECT_EQ(error_of([&] { world.add({0, 0, 0, 5}); }), "w must be a positive integer, but was 0(number)");
  EXPECT_EQ(error_of([&] { world.add({0, 0, 5, -3}); }), "h must be a positive integer, but was -3(number)");
  EXPECT_EQ(error_of([&] {
              world.add({0, 0, -0.1, -3});
            }),
            "w must be a positive integer, but was -0.1(number)");
  EXPECT_EQ(error_of([&] {
              world.add({0, 0, -1e20, 1});
            }),
            "w must be a positive integer, but was -1e+20(number)");
  EXPECT_EQ(world.item_count(), 0u);
  const ItemId a = world.add({0, 0, 1, 1});
  EXPECT_THROW(world.update(a, Rect{4, 4, 0, 1}), WorldError);
  EXPECT_EQ(world.rect(a), (Rect{0, 0, 1, 1}));
  EXPECT_THROW(in_rect(world, {0, 0, 1, 0}), WorldError);
  std::vector<Collision> hits;
  EXPECT_THROW(world.project(
                   {}, {0, 0, 0, 1}, {1, 1}, [](ItemId, ItemId) { return Response::slide; }, hits),
               WorldError);
}

TEST(WorldItems, MoveToOtherCellsWhenUpdated) {
  World world(10);
  const ItemId a = world.add({1, 1, 2, 2});
  EXPECT_EQ(world.cell_count(), 1u);
  world.update(a, Rect{25, 5, 10, 10});  // columns 3 and 4, rows 1 and 2
  EXPECT_EQ(world.cell_count(), 5u);
  EXPECT_THAT(in_rect(world, {0, 0, 10, 10}), IsEmpty());
  for (const Vec2 corner : {Vec2{26, 6}, Vec2{34, 6}, Vec2{26, 14}, Vec2{34, 14}}) {
    EXPECT_THAT(in_rect(world, {corner.x, corner.y, 0.5, 0.5}), ElementsAre(a))
        << corner.x << " " << corner.y;
  }
  world.update(a, Vec2{1, 1});
  EXPECT_EQ(world.rect(a), (Rect{1, 1, 10, 10}));
}

TEST(WorldItems, LeaveTheirCellsBehindUntilCollected) {
  World world(10);
  const ItemId a = world.add({1, 1, 2, 2});
  for (int i = 1; i <= 20; ++i) world.update(a, Vec2{10.0 * i + 1, 1});
  EXPECT_EQ(world.cell_count(), 21u);
  world.collect_empty_cells();
  EXPECT_EQ(world.cell_count(), 1u);
  EXPECT_THAT(in_rect(world, {200, 0, 5, 5}), ElementsAre(a));
  world.remove(a);
  world.collect_empty_cells();
  EXPECT_EQ(world.cell_count(), 0u);
}

TEST(WorldItems, WanderWithoutPilingUpEmptyCells) {
  World world(10);
  const ItemId a = world.add({1, 1, 2, 2});
  for (int i = 1; i <= 10'000; ++i) world.update(a, Vec2{10.0 * i + 1, 1});
  EXPECT_LT(world.cell_count(), 100u);
  EXPECT_THAT(in_rect(world, {100'000, 0, 5, 5}), ElementsAre(a));
}

TEST(WorldItems, AreAtZeroWhenPlacedAtMinusZero) {
  World world;
  const ItemId a = world.add({0, 0, 1, 1});
  world.update(a, Vec2{-0.0, 0});
  EXPECT_FALSE(std::signbit(world.rect(a).x));
  world.update(a, Vec2{-0.0, 3});
  EXPECT_TRUE(std::signbit(world.rect(a).x));
}

//   cell:   0 | 1 | 2       boundaries belong to the cell on their right
//   x:    -64 0  64
TEST(WorldCells, AreCountedFromOne) {
  const World world(64);
  EXPECT_EQ(world.to_cell({0, 0}), (Cell{1, 1}));
  EXPECT_EQ(world.to_cell({63.999, 64}), (Cell{1, 2}));
  EXPECT_EQ(world.to_cell({-0.0, -0.001}), (Cell{1, 0}));
  EXPECT_EQ(world.to_cell({-64, -64.001}), (Cell{0, -1}));
  EXPECT_EQ(world.to_world({1, 1}), (Vec2{0, 0}));
  EXPECT_EQ(world.to_world({0, 3}), (Vec2{-64, 128}));
  EXPECT_THROW(world.to_cell({kNan, 0}), WorldError);
  EXPECT_THROW(world.to_cell({0, kInfinity}), WorldError);
}

TEST(WorldCells, MustHaveAPositiveFiniteSize) {
  EXPECT_EQ(error_of([] { World world(0); }), "cellSize must be a positive integer, but was 0(number)");
  EXPECT_THROW(World(-4), WorldError);
  EXPECT_THROW(World{kNan}, WorldError);
  EXPECT_THROW(World{kInfinity}, WorldError);
  EXPECT_EQ(World(0.25).cell_size(), 0.25);
}

TEST(WorldNumbers, NanIsAcceptedAndLiesInNoCell) {
  World world;
  const ItemId a = world.add({kNan, 0, 8, 8});
  const ItemId b = world.add({0, 0, kNan, 8});
  const ItemId c = world.add({0, 0, 8, 8});
  EXPECT_EQ(world.item_count(), 3u);
  EXPECT_THAT(in_rect(world, {-10, -10, 100, 100}), ElementsAre(c));
  EXPECT_THAT(in_rect(world, {-10, kNan, 100, 100}), IsEmpty());
  std::vector<Collision> hits;
  const Vec2 lost = world.move(c, {kNan, 3}, hits);
  EXPECT_TRUE(std::isnan(lost.x));
  EXPECT_EQ(lost.y, 3);
  EXPECT_THAT(in_rect(world, {-10, -10, 100, 100}), IsEmpty());
  world.update(a, Rect{0, 0, 8, 8});
  EXPECT_THAT(in_rect(world, {-10, -10, 100, 100}), ElementsAre(a));
  world.remove(b);
  world.remove(c);
  std::vector<ItemId> found;
  world.query_point({kNan, 1}, found);
  EXPECT_THAT(found, IsEmpty());
  std::vector<SegmentHit> cut;
  world.query_segment({kNan, 1}, {5, 5}, cut);
  EXPECT_THAT(cut, IsEmpty());
}

TEST(WorldNumbers, InfinityAndFarCellsAreRefusedAndChangeNothing) {
  World world(1);
  const ItemId a = world.add({0, 0, 8, 8});
  const ItemId wall = world.add({20, 0, 8, 8});
  std::vector<Collision> hits;
  const auto bounce = [](ItemId, ItemId) { return Response::bounce; };
  EXPECT_THROW(world.add({kInfinity, 0, 8, 8}), WorldError);
  EXPECT_THROW(world.add({0, 0, kInfinity, 8}), WorldError);
  EXPECT_THROW(world.add({0, 1e300, 8, 8}), WorldError);
  EXPECT_THROW(world.add({0, 0, 5000, 5000}), WorldError);
  EXPECT_THROW(world.update(a, Vec2{0, -kInfinity}), WorldError);
  EXPECT_THROW(world.move(a, {kInfinity, 0}, hits), WorldError);
  EXPECT_THROW(world.move(a, {1 << 30, 0}, bounce, hits), WorldError);
  EXPECT_THROW(in_rect(world, {0, -1e18, 1, 1}), WorldError);
  std::vector<SegmentHit> cut;
  EXPECT_THROW(world.query_segment({0, 0}, {kInfinity, 0}, cut), WorldError);
  EXPECT_EQ(world.rect(a), (Rect{0, 0, 8, 8}));
  EXPECT_THAT(all_items(world), ElementsAre(a, wall));
  EXPECT_THAT(in_rect(world, {-10, -10, 100, 100}), ElementsAre(a, wall));
  EXPECT_EQ(world.move(a, {0, 1e9}, hits), (Vec2{0, 1e9}));
}

// A sweep over more cells than there are items tests the items instead, with the same answer.
TEST(WorldNumbers, LongMovesMeetTheSameItemsAsShortOnes) {
  World world(1);
  const ItemId a = world.add({0, 0, 1, 1});
  const ItemId wall = world.add({1'000'000, 1'000'000, 4, 4});
  std::vector<Collision> hits;
  world.move(
      a, {2'000'000, 2'000'000}, [](ItemId, ItemId) { return Response::touch; }, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].other, wall);
  EXPECT_EQ(hits[0].touch.x, 999'999);
}

// The memory of the grid is bounded for all items together.
TEST(WorldItems, TheNumberOfCoveredCellsIsLimited) {
  World world(1);
  const ItemId first = world.add({0, 0, 1000, 1000});
  EXPECT_THROW(world.add({0, 0, 1000, 1000}), WorldError);
  EXPECT_EQ(world.item_count(), 1u);
  const ItemId second = world.add({0, 0, 100, 100});
  EXPECT_THROW(world.update(second, {0, 0, 1000, 1000}), WorldError);
  EXPECT_EQ(world.rect(second), (Rect{0, 0, 100, 100}));
  world.update(first, {0, 0, 10, 10});
  world.update(second, {0, 0, 1000, 1000});
  world.remove(second);
  EXPECT_TRUE(world.add({5, 5, 1000, 1000}));
}

}  // namespace talus::world_items_test
