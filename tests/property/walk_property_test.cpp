// Properties of walks of the exact solver along random floors of flat tiles and slopes: a player goes on
// along each floor and each tunnel that it fits in, whatever of it is solid or one-way. TALUS_WALK_FLOORS:
// the number of floors for each property, at least kFloors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <talus/sim/solver.h>
#include "random_ground.h"
#include "tries.h"

namespace talus::walk_property_test {

constexpr double kFloors = 40;
constexpr int kSide = 8;                  // px, of a tile
constexpr int kColumns = 60, kRows = 40;  // cells of the map
constexpr int kBefore = 6, kBehind = 14;  // level columns at both ends, where a player starts and turns
constexpr int kRoom = 16;                 // px, between the floor and the ceiling of a tunnel

// Heights of the floor above the bottom of the map at the sides of the columns, px: multiples of 4. Each
// column is level, or a slope of 27 or 45 degrees within one cell.
struct Floor {
  std::vector<int> heights;
  std::vector<bool> one_way;
  double y_at(double x) const {
    const auto column = static_cast<std::size_t>(std::clamp(x / kSide, 0.0, kColumns - 1.0));
    const double share = x / kSide - static_cast<double>(column);
    return kRows * kSide - std::lerp(heights[column], heights[column + 1], share);
  }
};

Floor random_floor(Dice& dice, bool only_steep) {
  Floor floor;
  int height = 96;
  floor.heights.push_back(height);
  for (int column = 0; column < kColumns; ++column) {
    const bool is_level = column < kBefore || column >= kColumns - kBehind;
    const int steps[] = {0, 8, -8, 4, -4};
    int step = is_level ? 0 : steps[dice.up_to(only_steep ? 2 : 4)];
    if (height % kSide != 0 && std::abs(step) == kSide) step /= 2;  // stays within the cell
    if (height + step < 32 || height + step > 200) step = 0;
    height += step;
    floor.heights.push_back(height);
    floor.one_way.push_back(dice.one_in(2));
  }
  return floor;
}

TileShape slope(double left, double right, TileShape::Side side, bool one_way) {
  TileShape shape;
  shape.kind = left == 0 && right == 0 ? TileShape::Kind::solid : TileShape::Kind::slope;
  shape.side = side;
  shape.one_way = one_way;
  if (shape.kind == TileShape::Kind::slope) shape.heights = {left, right};
  return shape;
}

struct Walker {
  double width = 8, height = 8, speed = 1.5;
  Foot foot = Foot::centre;
  bool surface_speed = false, single_precision = false;
};

// Gives each cell that is not air a tile of its own.
class LevelMaker {
 public:
  explicit LevelMaker(const Walker& walker) {
    level_.map = TileMap(kColumns, kRows);
    level_.tuning.solver = SolverKind::exact;
    level_.tuning.player.run_speed = walker.speed;
    level_.tuning.player.run_gain = level_.tuning.player.run_loss = walker.speed;
    level_.tuning.player.surface_speed = walker.surface_speed ? 1 : 0;
    level_.tuning.exact.single_precision = walker.single_precision ? 1 : 0;
    level_.tile_shapes = {{}, slope(0, 0, TileShape::Side::floor, false)};
  }
  void put(int column, int row, const TileShape& shape) {
    const auto known = std::find(level_.tile_shapes.begin() + 1, level_.tile_shapes.end(), shape);
    const auto tile = static_cast<TileNumber>(known - level_.tile_shapes.begin());
    if (known == level_.tile_shapes.end()) level_.tile_shapes.push_back(shape);
    level_.map.set({column, row}, tile);
  }
  void fill(int column, int from_row, int to_row) {
    for (int row = std::max(from_row, 0); row < std::min(to_row, kRows); ++row)
      put(column, row, slope(0, 0, TileShape::Side::floor, false));
  }
  void add_floor(const Floor& floor, bool with_one_way) {
    for (int column = 0; column < kColumns; ++column) {
      const int left = floor.heights[static_cast<std::size_t>(column)];
      const int right = floor.heights[static_cast<std::size_t>(column) + 1];
      const bool one_way = with_one_way && floor.one_way[static_cast<std::size_t>(column)];
      const int base = std::min(left, right) / kSide * kSide, row = kRows - base / kSide;
      const bool is_flat = left == base && right == base;
      put(column, is_flat ? row : row - 1, slope(left - base, right - base, TileShape::Side::floor, one_way));
      if (!one_way) fill(column, is_flat ? row + 1 : row, kRows);
    }
  }
  void add_ceiling(const Floor& floor) {
    for (int column = 0; column < kColumns; ++column) {
      const int left = floor.heights[static_cast<std::size_t>(column)] + kRoom;
      const int right = floor.heights[static_cast<std::size_t>(column) + 1] + kRoom;
      const int top = (std::max(left, right) + kSide - 1) / kSide * kSide, row = kRows - top / kSide;
      if (left != top || right != top)
        put(column, row, slope(top - left, top - right, TileShape::Side::ceiling, false));
      fill(column, row - 3, row);
    }
  }
  Level take(const Floor& floor, const Walker& walker) {
    Spawn player;
    player.kind = BodyKind::player;
    player.foot = walker.foot;
    player.size = {walker.width, walker.height};
    player.position = {kSide, kRows * kSide - floor.heights[0] - walker.height};
    level_.spawns = {player};
    return std::move(level_);
  }

 private:
  Level level_;
};

struct Play {
  explicit Play(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        state(initial_state(*scene)) {}
  const Body& step(int direction) {
    Input input;
    input.left = direction < 0;
    input.right = direction > 0;
    solver->step(state, input, nullptr);
    return state.bodies.front();
  }
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State state;
};

// Walks to the right end and back. Calls check(body, direction) after each step but the first ones.
template <class Check>
void walk_there_and_back(Play& play, const Walker& walker, Check check) {
  constexpr int kFirst = 8;  // steps, in which it comes to stand
  for (int i = 0; i < kFirst; ++i) play.step(0);
  const double end = (kColumns - kBehind / 2) * kSide;
  for (const int direction : {1, -1}) {
    double before = play.state.bodies.front().box.x;
    const auto limit = static_cast<int>(3 * kColumns * kSide / walker.speed);
    int steps = 0;
    for (; steps < limit && (direction > 0 ? before < end : before > 2 * kSide); ++steps) {
      const Body& body = play.step(direction);
      if (steps > 1) {
        ASSERT_GT((body.box.x - before) * direction, 0) << "stops at x " << before;
      }
      ASSERT_TRUE(body.gait.grounded) << "leaves the floor at x " << before;
      before = body.box.x;
      check(body, direction);
      if (testing::Test::HasFatalFailure()) return;
    }
    ASSERT_LT(steps, limit);
  }
}

std::vector<Walker> walkers() {
  return {{},
          {.width = 14, .height = 20, .speed = 2.3, .surface_speed = true},
          {.width = 3, .height = 12, .speed = 0.37},
          {.width = 30, .height = 24, .speed = 7.9},
          {.foot = Foot::box},
          {.width = 9.5, .speed = 3.3, .foot = Foot::box, .surface_speed = true}};
}

template <class Check>
void for_floors(bool only_steep, Check check) {
  const auto floors = static_cast<std::uint64_t>(tries("TALUS_WALK_FLOORS", kFloors));
  for (std::uint64_t number = 1; number <= floors && !testing::Test::HasFailure(); ++number) {
    Dice dice(number);
    const Floor floor = random_floor(dice, only_steep);
    check(floor, number);
  }
}

TEST(WalkProperty, OneWayPartsOfAFloorAreWalkedAsSolidOnes) {
  const std::vector<Walker> all = walkers();
  for_floors(false, [&](const Floor& floor, std::uint64_t number) {
    const Walker& walker = all[number % all.size()];
    SCOPED_TRACE("floor " + std::to_string(number));
    LevelMaker mixed(walker), solid(walker);
    mixed.add_floor(floor, true);
    solid.add_floor(floor, false);
    Play on_mixed(mixed.take(floor, walker)), on_solid(solid.take(floor, walker));
    for (int i = 0; i < 8; ++i) on_solid.step(0);
    walk_there_and_back(on_mixed, walker, [&](const Body& body, int direction) {
      const Body& other = on_solid.step(direction);
      ASSERT_NEAR(body.box.x, other.box.x, 1e-9);
      ASSERT_NEAR(body.box.y, other.box.y, 1e-9);
      if (walker.foot == Foot::centre) {
        ASSERT_NEAR(body.box.bottom(), floor.y_at(body.box.x + body.box.w / 2), 1e-9);
      }
    });
  });
}

TEST(WalkProperty, TunnelsWithoutSpareRoomAreWalkedThrough) {
  for_floors(true, [](const Floor& floor, std::uint64_t number) {
    SCOPED_TRACE("tunnel " + std::to_string(number));
    // A box that stands on its whole bottom needs its width more, one on its centre half of it, at 45
    // degrees.
    Walker walker{.speed = number % 3 == 0 ? 2.37 : 1.5, .surface_speed = number % 3 == 0};
    walker.foot = number % 2 == 0 ? Foot::centre : Foot::box;
    walker.height = walker.foot == Foot::centre ? kRoom - walker.width / 2 : kRoom - walker.width;
    LevelMaker maker(walker);
    maker.add_floor(floor, number % 4 == 0);
    maker.add_ceiling(floor);
    Play play(maker.take(floor, walker));
    walk_there_and_back(play, walker, [](const Body&, int) {});
  });
}

// The way of the case one-way-valley-bump: a body that drifts to the right and does not bounce.
TEST(WalkProperty, OneWayFloorsCarryBodiesOfTheSolverBump) {
  for_floors(false, [](const Floor& floor, std::uint64_t number) {
    SCOPED_TRACE("floor " + std::to_string(number));
    const Walker walker;
    LevelMaker maker(walker);
    Floor one_way = floor;
    one_way.one_way.assign(kColumns, true);
    maker.add_floor(one_way, true);
    Level level = maker.take(one_way, walker);
    level.tuning.solver = SolverKind::bump;
    level.spawns[0].kind = BodyKind::ball;
    level.spawns[0].position.x += 0.37 * static_cast<double>(number % 20);
    SharedTuning& tuning = level.tuning.shared;
    tuning.drift_speed = 1.1, tuning.drift_blend = 1, tuning.fall_speed = 5, tuning.floor_grip = 1;
    tuning.floor_bounce = tuning.slope_bounce = tuning.wall_bounce = 0;
    constexpr double kDeepest =
        0.3;  // px; where a slope ends on a level floor, a foot may be in its last part
    Play play(level);
    for (int i = 0; i < 400; ++i) {
      const Body& body = play.step(0);
      if (body.box.x > (kColumns - kBehind / 2) * kSide) break;
      for (double x = body.box.x; x <= body.box.right(); x += body.box.w / 4)
        ASSERT_LE(body.box.bottom(), floor.y_at(x) + kDeepest) << "falls through at x " << x;
    }
  });
}

TEST(WalkProperty, SinglePrecisionStopsNowhere) {
  for_floors(false, [](const Floor& floor, std::uint64_t number) {
    SCOPED_TRACE("floor " + std::to_string(number));
    Walker walker{.speed = 1.7, .single_precision = true};
    walker.foot = number % 2 == 0 ? Foot::centre : Foot::box;
    LevelMaker maker(walker);
    maker.add_floor(floor, true);
    Play play(maker.take(floor, walker));
    walk_there_and_back(play, walker, [](const Body&, int) {});
  });
}

}  // namespace talus::walk_property_test
