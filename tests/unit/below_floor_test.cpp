// Sides of tiles below a floor that leads up to their tops: they do not stop a body whose middle is above
// that floor, whether it walks, rolls or flies.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include <talus/sim/solver.h>

namespace talus::below_floor_test {

constexpr int kFloor = 96;  // px, y of the floor's top
constexpr int kRamp = 12;   // the column where the slope begins

enum class Ground { solid, one_way };

// A floor in row 12, and on it a slope that leads up to a block: tiles as high as one, with so much rise
// each.
Level hill(Ground ground, double rise) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(60, 14);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 0; x < 60; ++x) level.map.set({x, 12}, 1);
  const int columns = static_cast<int>(8 / rise);
  for (int i = 0; i < columns; ++i) {
    const auto tile = static_cast<TileNumber>(2 + i);
    level.tile_shapes[tile] = {.kind = TileShape::Kind::slope,
                               .one_way = ground == Ground::one_way,
                               .heights = {i * rise, (i + 1) * rise}};
    level.map.set({kRamp + i, 11}, tile);
  }
  for (int x = kRamp + columns; x < 60; ++x) level.map.set({x, 11}, 1);
  return level;
}

void put(Level& level, BodyKind kind, Vec2 size, double x, double above) {
  Spawn& spawn = level.spawns.emplace_back();
  spawn.kind = kind;
  spawn.position = {x, kFloor - size.y - above};
  spawn.size = size;
  spawn.foot = Foot::centre;
}

// Where the body is after each step. jump: the step in which a player that runs to the right jumps.
std::vector<Vec2> path(const Level& level, int steps, int jump = -1) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  std::vector<Vec2> places;
  for (int i = 0; i < steps; ++i) {
    Input input;
    input.right = true;
    input.jump = i == jump;
    solver->step(state, input, nullptr);
    places.push_back(state.bodies[0].box.position());
  }
  return places;
}

TEST(BelowFloor, ABallRollsOverAOneWaySlopeAsOverASolidOne) {
  for (const double rise : {2.0, 4.0, 8.0}) {
    for (const double bounce : {0.0, 0.5}) {
      for (const double above : {0.0, 7.0, 19.0}) {
        std::vector<Vec2> paths[2];
        for (const Ground ground : {Ground::solid, Ground::one_way}) {
          Level level = hill(ground, rise);
          put(level, BodyKind::ball, {10, 8}, 40, above);
          SharedTuning& tuning = level.tuning.shared;
          tuning.floor_bounce = bounce;
          tuning.wall_bounce = bounce;
          tuning.drift_speed = 1;
          tuning.drift_blend = 0.5;
          paths[static_cast<int>(ground)] = path(level, 120);
        }
        EXPECT_EQ(paths[0], paths[1]) << rise << " " << bounce << " " << above;
        const double least = rise < 8 ? 8 * kRamp + 10 : 0;
        EXPECT_GT(paths[1].back().x, least) << rise << " " << bounce << " " << above;
      }
    }
  }
}

TEST(BelowFloor, APlayerThatJumpsFromAOneWaySlopeKeepsItsSpeed) {
  for (const double rise : {2.0, 4.0, 8.0}) {
    for (int jump = 20; jump < 70; jump += 3) {
      std::vector<Vec2> paths[2];
      for (const Ground ground : {Ground::solid, Ground::one_way}) {
        Level level = hill(ground, rise);
        put(level, BodyKind::player, {12, 8}, 40, 0);
        paths[static_cast<int>(ground)] = path(level, 100, jump);
      }
      EXPECT_EQ(paths[0], paths[1]) << rise << " " << jump;
    }
  }
}

TEST(BelowFloor, ABodyUnderTheSlopeIsStoppedByTheBlock) {
  Level level = hill(Ground::one_way, 1);
  for (int x = 0; x < kRamp + 7; ++x) level.map.set({x, 12}, 0);
  for (int x = 0; x < 60; ++x) level.map.set({x, 13}, 1);
  put(level, BodyKind::player, {4, 4}, 8.0 * (kRamp + 1), -8);
  EXPECT_EQ(path(level, 100).back().x, 8 * (kRamp + 7) - 4);
}

// It comes from below the one-way slope that goes on where a solid floor ends at (64, 64).
TEST(BelowFloor, ABodyUnderTheSlopeLandsOnTheEndOfItsFloor) {
  for (const bool is_block : {false, true}) {
    for (const bool is_segment : {false, true}) {
      for (const bool to_left : {false, true}) {
        for (const Foot foot : {Foot::box, Foot::centre}) {
          Level level;
          level.tuning.solver = SolverKind::exact;
          level.map = TileMap(16, 14);
          const double rise = to_left ? 8 : -8, low = to_left ? 0 : 8;
          level.tile_shapes[1].kind = TileShape::Kind::solid;
          level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .heights = {low, 8 - low}};
          level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .one_way = true, .heights = {low, 8 - low}};
          level.map.set({to_left ? 7 : 8, 8}, is_block ? 1 : 2);
          if (is_segment)
            level.curves.push_back({"", {Segment{{64, 64}, {64 + rise, 56}}, Curve::Faces::up}, ""});
          else
            level.map.set({to_left ? 8 : 7, 7}, 3);
          put(level, BodyKind::player, {8, 8}, to_left ? 64 : 56, kFloor - 63.5);
          level.spawns[0].foot = foot;
          const auto scene = std::make_shared<const Scene>(compile_scene(level));
          const auto solver = make_solver(scene);
          State state = initial_state(*scene);
          Input input;
          input.left = to_left;
          input.right = !to_left;
          for (int i = 0; i < 10 && !state.bodies[0].gait.grounded; ++i) solver->step(state, input);
          const Body& body = state.bodies[0];
          EXPECT_TRUE(body.gait.grounded);
          EXPECT_EQ(body.box.bottom(), 64) << is_block << is_segment << to_left << static_cast<int>(foot);
          EXPECT_TRUE(to_left ? body.box.x < 64 : body.box.right() > 64);
        }
      }
    }
  }
}

}  // namespace talus::below_floor_test
