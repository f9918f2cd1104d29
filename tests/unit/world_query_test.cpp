// Queries for a rectangle, a point and a segment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/collision/world.h>

namespace talus::world_query_test {

using testing::ElementsAre;
using testing::IsEmpty;

//   +--+ +--+
//   |a | |b |    a at 0, b at 20, c below a; each 10 wide, cells of 8, so that items span several
//   +--+ +--+
//   |c |
//   +--+
class WorldQueries : public testing::Test {
 protected:
  std::vector<ItemId> in_rect(Rect rect) const {
    std::vector<ItemId> found;
    world.query_rect(rect, found);
    return found;
  }
  std::vector<ItemId> at(Vec2 point) const {
    std::vector<ItemId> found;
    world.query_point(point, found);
    return found;
  }
  std::vector<SegmentHit> cut(Vec2 from, Vec2 to) const {
    std::vector<SegmentHit> found;
    world.query_segment(from, to, found);
    return found;
  }
  std::vector<ItemId> cut_items(Vec2 from, Vec2 to) const {
    std::vector<ItemId> items;
    for (const SegmentHit& hit : cut(from, to)) items.push_back(hit.item);
    return items;
  }

  World world{8};
  ItemId c = world.add({0, 10, 10, 10});
  ItemId b = world.add({20, 0, 10, 10});
  ItemId a = world.add({0, 0, 10, 10});
};

TEST_F(WorldQueries, RectFindsStrictOverlapsInOrderOfAdding) {
  EXPECT_THAT(in_rect({5, 5, 20, 10}), ElementsAre(c, b, a));
  EXPECT_THAT(in_rect({10, 0, 10, 10}), IsEmpty());
  EXPECT_THAT(in_rect({10, 0, 10.001, 10}), ElementsAre(b));
  EXPECT_THAT(in_rect({-5, -5, 100, 5}), IsEmpty());
}

TEST_F(WorldQueries, PointFindsItemsThatContainIt) {
  EXPECT_THAT(at({5, 5}), ElementsAre(a));
  EXPECT_THAT(at({5, 10}), IsEmpty());
  EXPECT_THAT(at({5, 10 + 0.5e-10}), IsEmpty());
  EXPECT_THAT(at({5, 10 + 2e-10}), ElementsAre(c));
  EXPECT_THAT(at({15, 5}), IsEmpty());
  EXPECT_THAT(at({1e300, 0}), IsEmpty());
}

TEST_F(WorldQueries, SegmentFindsItemsInOrderFromItsStart) {
  EXPECT_THAT(cut_items({-5, 5}, {40, 5}), ElementsAre(a, b));
  EXPECT_THAT(cut_items({40, 5}, {-5, 5}), ElementsAre(b, a));
  EXPECT_THAT(cut_items({5, -5}, {5, 40}), ElementsAre(a, c));
  EXPECT_THAT(cut_items({-5, -5}, {40, -5}), IsEmpty());
  EXPECT_THAT(cut_items({15, 0}, {15, 9}), IsEmpty());
}

TEST_F(WorldQueries, SegmentTellsWhereItEntersAndLeaves) {
  const auto hits = cut({-10, 5}, {30, 5});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].ti1, 0.25);
  EXPECT_EQ(hits[0].ti2, 0.5);
  EXPECT_EQ(hits[0].enter, (Vec2{0, 5}));
  EXPECT_EQ(hits[0].leave, (Vec2{10, 5}));
  EXPECT_EQ(hits[1].enter, (Vec2{20, 5}));
  EXPECT_EQ(hits[1].leave, (Vec2{30, 5}));
}

TEST_F(WorldQueries, SegmentThatBeginsInsideIsReported) {
  const auto hits = cut({5, 5}, {15, 5});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].item, a);
  EXPECT_EQ(hits[0].ti1, 0);
  EXPECT_EQ(hits[0].ti2, 0.5);
}

// bump's quirk, kept: neither end of the overlap lies strictly inside the segment.
TEST_F(WorldQueries, SegmentThatStaysInsideIsNotReported) {
  EXPECT_THAT(cut({4, 5}, {6, 5}), IsEmpty());
  EXPECT_THAT(cut({5, 5}, {5, 5}), IsEmpty());
}

// The segment runs through the common corners of four cells. An item that it only just reaches is found.
TEST_F(WorldQueries, SegmentThroughCellCornersMissesNothing) {
  const ItemId small = world.add({17, 33, 1, 6});
  const ItemId corner = world.add({24, 23, 1, 10});
  EXPECT_THAT(cut_items({0, 56}, {56, 0}), ElementsAre(small, corner));
  EXPECT_THAT(cut_items({56, 0}, {0, 56}), ElementsAre(corner, small));
}

TEST_F(WorldQueries, FiltersLeaveItemsOut) {
  const auto not_a = [this](ItemId item) { return item != a; };
  std::vector<ItemId> found{a};
  world.query_rect({-5, -5, 100, 100}, not_a, found);
  EXPECT_THAT(found, ElementsAre(c, b));
  world.query_point({5, 5}, not_a, found);
  EXPECT_THAT(found, IsEmpty());
  std::vector<SegmentHit> hits;
  world.query_segment({-5, 5}, {40, 5}, not_a, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].item, b);
}

TEST_F(WorldQueries, FiltersMayAskTheWorldToo) {
  std::vector<SegmentHit> hits;
  world.query_segment(
      {-5, 5}, {40, 5},
      [this](ItemId item) {
        return cut_items({-5, 5}, {40, 5}).size() == 2 && item != b;
      },
      hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].item, a);
}

TEST(WorldQueriesFar, SegmentOfMillionsOfCellsIsAnswered) {
  World world(1);
  const ItemId goal = world.add({50'000'000, 10'000'000, 5, 5});
  std::vector<SegmentHit> hits;
  world.query_segment({0, 0}, {100'000'005, 20'000'005}, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].item, goal);
}

}  // namespace talus::world_query_test
