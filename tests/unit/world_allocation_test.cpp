// A warm World allocates nothing. The test counts every operator new of its thread.
#include <gtest/gtest.h>

#include <talus/collision/world.h>
#include "faults/failing_memory.h"

namespace talus::world_allocation_test {

constexpr auto kCross = [](ItemId, ItemId) { return Response::cross; };

class WorldAllocation : public testing::TestWithParam<World::Mode> {};

// A crowd in a closed room. It moves by a fixed pattern, with contacts and changes of cells in every round.
struct Crowd {
  World world;
  std::vector<ItemId> movers;
  std::vector<Collision> hits;
  std::vector<ItemId> found;
  std::vector<SegmentHit> cut;

  explicit Crowd(World::Mode mode) : world(24, mode) {
    for (int i = 0; i < 20; ++i) {
      world.add({i * 16.0, 0, 16, 16});
      world.add({i * 16.0, 304, 16, 16});
      world.add({0, i * 16.0, 16, 16});
      world.add({304, i * 16.0, 16, 16});
    }
    for (int i = 0; i < 40; ++i) movers.push_back(world.add({20.0 + 7 * i, 20.0 + 6 * i, 6, 6}));
    world.add_response("own", [](const World& w, Collision& hit, Rect start, Vec2 goal, World::Filter filter,
                                 std::vector<Collision>& next) {
      w.project(hit.item, start, goal, filter, next);
      return goal;
    });
  }

  void round(int frame) {
    const Response own = Response::first_user;
    for (std::size_t i = 0; i < movers.size(); ++i) {
      const auto phase = static_cast<int>(i) + frame;
      const Vec2 d{(phase * 7) % 23 - 11.0, (phase * 5) % 19 - 9.0};
      const Vec2 goal = world.rect(movers[i]).position() + d;
      world.move(movers[i], goal, hits);
      world.check(
          movers[i], goal, [&](ItemId, ItemId other) { return other.index % 2 ? own : Response::bounce; },
          hits);
      world.project(movers[i], world.rect(movers[i]), goal, kCross, hits);
      world.query_rect({goal.x, goal.y, 40, 40}, found);
      world.query_point(goal, found);
      world.query_segment(goal, {160, 160}, cut);
    }
  }
};

TEST_P(WorldAllocation, AWarmWorldAllocatesNothing) {
  constexpr int kRounds = 200;
  Crowd crowd(GetParam());
  std::vector<Rect> start;
  for (const ItemId mover : crowd.movers) start.push_back(crowd.world.rect(mover));
  for (int frame = 0; frame < kRounds; ++frame) crowd.round(frame);
  for (std::size_t i = 0; i < start.size(); ++i) crowd.world.update(crowd.movers[i], start[i]);

  const std::size_t before = allocations_made();
  ASSERT_GT(before, 0u);
  for (int frame = 0; frame < kRounds; ++frame) crowd.round(frame);
  EXPECT_EQ(allocations_made(), before);
  EXPECT_NE(crowd.world.rect(crowd.movers[0]), start[0]);
}

INSTANTIATE_TEST_SUITE_P(Modes, WorldAllocation, testing::Values(World::Mode::faithful, World::Mode::robust));

}  // namespace talus::world_allocation_test
