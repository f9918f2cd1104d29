// Walks of the exact solver: where a player goes on along the floor, and where it is stopped.
#include <gtest/gtest.h>

#include <memory>

#include <talus/sim/solver.h>

namespace talus::walk_test {

constexpr int kFloor = 96;  // px, y of the floor's top

// A floor in row 12, with tiles of these shapes on it from column 5 on.
struct Scenery {
  Scenery() {
    level.tuning.solver = SolverKind::exact;
    level.map = TileMap(40, 14);
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    for (int x = 0; x < 40; ++x) level.map.set({x, 12}, 1);
  }
  void put(Cell cell, TileShape shape) {
    level.tile_shapes[next] = std::move(shape);
    level.map.set(cell, next++);
  }
  void fill(int from, int to, int row) {
    for (int x = from; x <= to; ++x) level.map.set({x, row}, 1);
  }
  void player(double x, double y, Foot foot, Vec2 size = {8, 8}) {
    Spawn& spawn = level.spawns.emplace_back();
    spawn.kind = BodyKind::player;
    spawn.position = {x, y - size.y};
    spawn.size = size;
    spawn.foot = foot;
  }
  Level level;
  TileNumber next = 2;
};

TileShape slope(double left, double right, bool one_way = false) {
  return {.kind = TileShape::Kind::slope, .one_way = one_way, .heights = {left, right}};
}

// The player after these steps in a direction; each step must leave it on a floor.
Body walked(const Level& level, int direction, int steps) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  for (int i = 0; i < 4 + steps; ++i) {
    Input input;
    input.left = i >= 4 && direction < 0;
    input.right = i >= 4 && direction > 0;
    solver->step(state, input, nullptr);
    if (i >= 4) {
      EXPECT_TRUE(state.bodies[0].gait.grounded) << "step " << i - 4;
    }
  }
  return state.bodies[0];
}

TEST(Walk, LeadsFromAOneWaySlopeOntoSolidGround) {
  for (const double rise : {2.0, 4.0, 8.0}) {  // 14, 27 and 45 degrees
    for (const double width : {2.0, 8.0, 15.0, 40.0}) {
      Scenery scenery;
      const int columns = static_cast<int>(8 / rise);
      for (int i = 0; i < columns; ++i) scenery.put({8 + i, 11}, slope(i * rise, (i + 1) * rise, true));
      scenery.fill(8 + columns, 39, 11);
      scenery.player(10, kFloor, Foot::centre, {width, 12});
      const Body body = walked(scenery.level, 1, 110);
      EXPECT_GT(body.box.x + width / 2, 8 * (8 + columns) + 10) << rise << " " << width;
      EXPECT_EQ(body.box.bottom(), kFloor - 8) << rise << " " << width;
    }
  }
}

TEST(Walk, LeadsUpIntoACorridorThatTheBodyFits) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Scenery scenery;
    scenery.put({8, 11}, slope(0, 8));
    scenery.fill(9, 39, 11);
    scenery.fill(9, 39, 9);
    scenery.player(20, kFloor, foot);
    const Body body = walked(scenery.level, 1, 80);
    EXPECT_GT(body.box.x, 110);
    EXPECT_EQ(body.box.bottom(), kFloor - 8);
  }
}

TEST(Walk, StaysOnAPlateauBelowAOneWayLine) {
  for (const double speed : {0.7, 1.5, 6.0}) {
    for (double start = 20; start < 26; start += 0.5) {
      Scenery scenery;
      scenery.level.tuning.player.run_speed = speed;
      scenery.put({8, 11}, slope(0, 8));
      scenery.fill(9, 39, 11);
      for (int x = 9; x < 40; ++x) scenery.put({x, 10}, slope(1, 1, true));
      scenery.player(start, kFloor, Foot::box);
      const Body body = walked(scenery.level, 1, static_cast<int>(150 / speed));
      EXPECT_GT(body.box.x, 90);
      EXPECT_EQ(body.box.bottom(), kFloor - 8) << speed << " from " << start;
    }
  }
}

TEST(Walk, EndsAtABlockThatTheFloorDoesNotLeadOnto) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0, 7, true));  // 1 px below the top of the block
  scenery.fill(9, 39, 11);
  scenery.player(20, kFloor, Foot::centre);
  EXPECT_EQ(walked(scenery.level, 1, 80).box.right(), 72);
}

TEST(Walk, EndsAtTheSideOfABlockUnderAOneWaySlope) {
  Scenery scenery;
  scenery.put({8, 10}, slope(0, 8, true));
  scenery.fill(9, 39, 10);
  scenery.fill(9, 39, 11);
  scenery.player(20, kFloor, Foot::centre);
  const Body body = walked(scenery.level, 1, 80);
  EXPECT_EQ(body.box.right(), 72);
  EXPECT_EQ(body.box.bottom(), kFloor);
}

TEST(Walk, PassesTheEndOfAFloorBelowItsLine) {
  Scenery scenery;  // a one-way slope leads down over the corner of a block
  scenery.fill(8, 9, 11);
  scenery.put({8, 10}, slope(8, 4, true));
  scenery.put({9, 10}, slope(4, 0, true));
  scenery.put({10, 11}, slope(8, 0, true));
  scenery.fill(6, 7, 10);
  scenery.fill(6, 7, 11);
  scenery.player(50, kFloor - 16, Foot::centre);
  const Body body = walked(scenery.level, 1, 60);
  EXPECT_EQ(body.box.bottom(), kFloor);
  EXPECT_GT(body.box.x, 100);
}

TEST(Walk, GoesAsFastOverEachPiece) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0, 8));
  scenery.fill(9, 20, 11);
  scenery.put({21, 11}, slope(8, 0));
  scenery.player(20, kFloor, Foot::box);
  const Body body = walked(scenery.level, 1, 106);
  const double ramp = 0.25 + 0.5 + 0.75 + 1 + 1.25;  // while run_gain makes it faster
  EXPECT_DOUBLE_EQ(body.box.x, 20 + ramp + 1.5 * 101);
}

}  // namespace talus::walk_test
