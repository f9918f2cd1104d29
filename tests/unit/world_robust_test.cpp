// The hard cases that a faithful World gets wrong and a robust World must not: seams, overlaps, far
// coordinates, sensors. Each case runs at distances S from the origin, where a unit in the last place grows
// with S.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <talus/collision/world.h>

namespace talus::world_robust_test {

constexpr double kDistances[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

class Random {
 public:
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }

 private:
  std::mt19937_64 engine_{20240229};
};

//        +--+
//   +--+ |  |   pushed in from the left, then 40 down past the seam:
//   |  |>|  |   nothing is in the way, so it must arrive exactly
//   +--+ +--+
//     v  |  |
double ghost_rate(World::Mode mode, double distance) {
  constexpr int kRuns = 400;
  Random random;
  int ghosts = 0;
  std::vector<Collision> hits;
  for (int run = 0; run < kRuns; ++run) {
    World world(64, mode);
    const Vec2 corner{distance * random.in(0.5, 1), distance * random.in(0.5, 1)};
    world.add({corner.x, corner.y, 16, 64});
    world.add({corner.x, corner.y + 64, 16, 64});
    const ItemId box = world.add({corner.x - 30, corner.y + 30, random.in(12, 13), 14});
    const Vec2 pushed = world.move(box, world.rect(box).position() + Vec2{25, 0}, hits);
    const Vec2 goal = pushed + Vec2{0, 40};
    const Vec2 end = world.move(box, goal, hits);
    ghosts += !hits.empty() || end != goal;
  }
  return static_cast<double>(ghosts) / kRuns;
}

TEST(WorldRobust, SlidesPastTheSeamOfAWall) {
  for (const double distance : kDistances)
    EXPECT_EQ(ghost_rate(World::Mode::robust, distance), 0) << distance;
  EXPECT_GT(ghost_rate(World::Mode::faithful, 1), 0);
  EXPECT_GT(ghost_rate(World::Mode::faithful, 1e4), 0.2);
}

//   +--+ ->
//   +--+
//  +--+--+--+--+--+   gravity and a walk along the floor: it must get to the end
double stuck_rate(World::Mode mode, double distance, double tile) {
  constexpr int kWorlds = 60;
  Random random;
  int stuck = 0;
  std::vector<Collision> hits;
  for (int run = 0; run < kWorlds; ++run) {
    World world(64, mode);
    const Vec2 corner{distance * random.in(-100, 100), distance * random.in(-100, 100)};
    for (int i = 0; i < 31; ++i) world.add({corner.x + i * tile, corner.y, tile, tile});
    const Vec2 size{tile * random.in(0.5, 1.5), tile * random.in(0.5, 1.5)};
    const ItemId box = world.add({corner.x, corner.y - size.y - random.in(0, tile), size.x, size.y});
    const double end = corner.x + 28 * tile;
    const double speed = tile * random.in(0.05, 0.2);
    double fall = 0;
    for (int frame = 0; frame < 700 && world.rect(box).x < end; ++frame) {
      fall += tile / 160;
      world.move(box, world.rect(box).position() + Vec2{speed, fall}, hits);
      if (std::any_of(hits.begin(), hits.end(), [](const Collision& hit) { return hit.normal.y != 0; }))
        fall = 0;
    }
    stuck += world.rect(box).x < end;
  }
  return static_cast<double>(stuck) / kWorlds;
}

TEST(WorldRobust, WalksOverTheSeamsOfAFloor) {
  for (const double tile : {1.0, 16.0, 32.0}) {
    for (const double distance : kDistances) {
      EXPECT_EQ(stuck_rate(World::Mode::robust, distance, tile), 0) << distance << " " << tile;
    }
    EXPECT_GT(stuck_rate(World::Mode::faithful, 1, tile), 0.02) << tile;
  }
}

//       ++-----+
//     +-||+    |   0.1 inside the wall: leaves by 0.1 to the left, whatever it wants
//     +-||+    |
//       ++-----+
TEST(WorldRobust, LeavesAnOverlapByItsShortestWay) {
  std::vector<Collision> hits;
  for (const double s : kDistances) {
    const auto move = [&](World::Mode mode, Vec2 d) {
      World world(64, mode);
      world.add({s + 100, s, 16, 640});
      const ItemId box = world.add({s + 100 - 12 + 0.1, s + 300, 12, 14});
      return world.move(box, world.rect(box).position() + d, hits) - Vec2{s, s};
    };
    const double ulp = std::nextafter(s + 400, 1e300) - (s + 400);
    for (const Vec2 d : {Vec2{0, 0}, Vec2{0, 1}, Vec2{0, -1}, Vec2{1, 0}, Vec2{1, 1}}) {
      const Vec2 end = move(World::Mode::robust, d);
      EXPECT_NEAR(end.x, 88, 2 * ulp) << s;
      EXPECT_NEAR(end.y, 300 + d.y, 2 * ulp) << s;
    }
    EXPECT_NEAR(move(World::Mode::robust, {-1, 0}).x, 87.1, 2 * ulp) << s;
  }
  World world(64);
  world.add({100, 0, 16, 640});
  const ItemId box = world.add({100 - 12 + 0.1, 300, 12, 14});
  EXPECT_EQ(world
                .check(
                    box, {88.1, 301}, [](ItemId, ItemId) { return Response::slide; }, hits)
                .y,
            -14);
}

// Pushes a box into a wall from a random side, then 1 away from it. A longer motion is a teleport.
double teleport_rate(World::Mode mode, double distance) {
  constexpr int kRuns = 400;
  Random random;
  int teleports = 0;
  std::vector<Collision> hits;
  for (int run = 0; run < kRuns; ++run) {
    World world(64, mode);
    const Rect wall{distance * random.in(0.5, 1), distance * random.in(0.5, 1), 16, 64};
    world.add(wall);
    const double w = random.in(5, 13);
    const bool left = random.in(0, 1) < 0.5;
    const ItemId box = world.add({left ? wall.x - 30 : wall.x + 30, wall.y + 20, w, 14});
    const double way = left ? 1 : -1;
    const Vec2 pushed = world.move(box, world.rect(box).position() + Vec2{way * 25, 0}, hits);
    const Vec2 goal = pushed - Vec2{way, 0};
    const Vec2 end = world.move(box, goal, hits);
    teleports += end != goal;
  }
  return static_cast<double>(teleports) / kRuns;
}

TEST(WorldRobust, LeavesAWallItWasPushedAgainst) {
  for (const double distance : kDistances) {
    EXPECT_EQ(teleport_rate(World::Mode::robust, distance), 0) << distance;
  }
  EXPECT_GT(teleport_rate(World::Mode::faithful, 1e7), 0.1);
}

// After any push the test for overlaps must find none, so that the next move starts outside.
TEST(WorldRobust, EndsWithoutAnOverlapHoweverFar) {
  Random random;
  std::vector<Collision> hits;
  std::vector<ItemId> overlapped;
  for (const double distance : kDistances) {
    for (int run = 0; run < 300; ++run) {
      World world(64, World::Mode::robust);
      const Rect wall{distance * random.in(-1, 1), distance * random.in(-1, 1), random.in(1, 40),
                      random.in(1, 40)};
      const ItemId other = world.add(wall);
      const double angle = random.in(0, 6.3);
      const Vec2 far{100 * std::cos(angle), 100 * std::sin(angle)};
      const Vec2 centre{wall.x + wall.w / 2, wall.y + wall.h / 2};
      const ItemId box = world.add({centre.x + far.x, centre.y + far.y, random.in(1, 20), random.in(1, 20)});
      world.move(box, centre, hits);
      const Rect a = world.rect(box);
      const double x = wall.x - a.x - a.w;
      const double y = wall.y - a.y - a.h;
      EXPECT_FALSE(x < 0 && y < 0 && x + (a.w + wall.w) > 0 && y + (a.h + wall.h) > 0) << distance;
      ASSERT_EQ(hits.size(), 1u) << distance;
      EXPECT_EQ(hits[0].other, other);
    }
  }
}

// A box as wide as a shaft touches both walls all the way and must fall freely.
TEST(WorldRobust, FallsThroughAShaftOfItsOwnWidth) {
  Random random;
  std::vector<Collision> hits;
  for (const double distance : kDistances) {
    for (int run = 0; run < 50; ++run) {
      World world(64, World::Mode::robust);
      const double x = distance * random.in(-1, 1);
      const double y = distance * random.in(-1, 1);
      const double w = random.in(5, 15);
      for (int i = 0; i < 20; ++i) {
        world.add({x - 16, y + 16 * i, 16, 16});
        world.add({x + w, y + 16 * i, 16, 16});
      }
      const ItemId box = world.add({x, y, w, 10});
      for (int frame = 0; frame < 40; ++frame) {
        const Vec2 from = world.rect(box).position();
        const double push = random.in(-1, 1);
        const Vec2 end = world.move(box, from + Vec2{push, 5}, hits);
        EXPECT_EQ(end.y, from.y + 5) << distance;
      }
      EXPECT_NEAR(world.rect(box).x, x, 8 * (std::nextafter(std::abs(x) + 16, 1e300) - (std::abs(x) + 16)));
    }
  }
}

// Random rooms with and without a sensor. The mover must end at the same place to the last bit.
int paths_bent_by_a_sensor(World::Mode mode) {
  Random random;
  int bent = 0;
  std::vector<Collision> hits;
  for (int run = 0; run < 2000; ++run) {
    std::vector<Rect> solids;
    for (int i = 0; i < 6; ++i) {
      solids.push_back({random.in(0, 80), random.in(0, 80), random.in(5, 30), random.in(5, 30)});
    }
    const Rect sensor{random.in(0, 80), random.in(0, 80), random.in(5, 30), random.in(5, 30)};
    const Rect mover{random.in(-30, -10), random.in(-30, 100), 8, 8};
    const Vec2 goal{random.in(0, 120), random.in(-30, 120)};
    const auto end = [&](bool with_sensor) {
      World world(32, mode);
      const ItemId box = world.add(mover);
      for (const Rect& solid : solids) world.add(solid);
      const ItemId zone = world.add(sensor);
      return world.move(
          box, goal,
          [&](ItemId, ItemId other) {
            if (other == zone) return with_sensor ? Response::cross : Response::ignore;
            return Response::slide;
          },
          hits);
    };
    bent += end(true) != end(false);
  }
  return bent;
}

TEST(WorldRobust, ASensorDoesNotBendThePath) {
  EXPECT_EQ(paths_bent_by_a_sensor(World::Mode::robust), 0);
  EXPECT_GT(paths_bent_by_a_sensor(World::Mode::faithful), 0);
}

//   ball      |wall
//    o--zone->|  zone beyond   the second zone is behind the wall: never reached, never reported
TEST(WorldRobust, ReportsOnlySensorsOnTheTravelledPath) {
  World world(64, World::Mode::robust);
  const ItemId ball = world.add({0, 0, 8, 8});
  const ItemId near_zone = world.add({20, 0, 8, 8});
  const ItemId wall = world.add({40, -50, 8, 100});
  const ItemId far_zone = world.add({60, 0, 8, 8});
  std::vector<Collision> hits;
  const Vec2 end = world.move(
      ball, {100, 0}, [&](ItemId, ItemId other) { return other == wall ? Response::slide : Response::cross; },
      hits);
  EXPECT_EQ(end, (Vec2{32, 0}));
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].other, near_zone);
  EXPECT_EQ(hits[1].other, wall);
  EXPECT_NE(hits[1].other, far_zone);
}

//  |  o->    |   20 wide inside, a ball of 4, the goal 200 ahead: it ends where a triangle wave does
TEST(WorldRobust, BouncesBetweenWallsForTheWholeMotion) {
  std::vector<Collision> hits;
  const auto end = [&](World::Mode mode) {
    World world(64, mode);
    world.add({-10, -10, 10, 30});
    world.add({20, -10, 10, 30});
    const ItemId ball = world.add({3, 0, 4, 4});
    return world.move(
        ball, {203, 0}, [](ItemId, ItemId) { return Response::bounce; }, hits);
  };
  // The free distance is 16, and 203 = 12 * 16 + 11: after an even number of turns the ball runs to the
  // right.
  EXPECT_EQ(end(World::Mode::robust), (Vec2{11, 0}));
  EXPECT_EQ(hits.size(), 12u);
  EXPECT_EQ(end(World::Mode::faithful), (Vec2{171, 0}));
  EXPECT_EQ(hits.size(), 2u);
}

TEST(WorldRobust, StopsAtTheLastContactOfEndlessBounces) {
  World world(64, World::Mode::robust);
  world.add({-10, -10, 10, 30});
  world.add({8, -10, 10, 30});
  const ItemId ball = world.add({0, 0, 8, 8});
  std::vector<Collision> hits;
  const Vec2 end = world.move(
      ball, {100, 0}, [](ItemId, ItemId) { return Response::bounce; }, hits);
  EXPECT_EQ(end, (Vec2{0, 0}));
  EXPECT_EQ(hits.size(), 64u);
}

TEST(WorldRobust, RejectsCoordinatesThatAreNotFinite) {
  World world(64, World::Mode::robust);
  const ItemId box = world.add({0, 0, 8, 8});
  std::vector<Collision> hits;
  EXPECT_THROW(world.add({NAN, 0, 8, 8}), WorldError);
  EXPECT_THROW(world.update(box, Rect{0, 0, INFINITY, 8}), WorldError);
  EXPECT_THROW(world.move(box, {NAN, 0}, hits), WorldError);
  EXPECT_THROW(world.move(box, {0, -INFINITY}, hits), WorldError);
  EXPECT_EQ(world.rect(box), (Rect{0, 0, 8, 8}));
}

}  // namespace talus::world_robust_test
