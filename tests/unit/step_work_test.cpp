// The work of a step is bounded in every level. A step that would take minutes stops bodies early, and says
// so.
#include <gtest/gtest.h>

#include <talus/sim/solver.h>
#include "cli/trace.h"
#include "collision/ground_queries.h"
#include "debug/explain.h"
#include "debug/metrics.h"
#include "level_picture.h"
#include "sim/body_grid.h"
#include "sim/step_limits.h"

namespace talus::step_work_test {

constexpr std::array kSolvers = {SolverKind::article, SolverKind::bump, SolverKind::exact};

Spawn ball(Vec2 position, Vec2 velocity = {}) {
  Spawn spawn;
  spawn.position = position;
  spawn.velocity = velocity;
  return spawn;
}

struct Steps {
  explicit Steps(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        state(initial_state(*scene)) {}
  void step() { solver->step(state, {}, &record); }
  bool cut_short(int body) const { return record.paths[static_cast<std::size_t>(body - 1)].cut_short; }

  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State state;
  StepRecord record;
};

// A step without a record must stop at the same place.
void expect_same_without_record(const Level& level, const Steps& run) {
  Steps other(level);
  while (other.state.frame < run.state.frame) other.solver->step(other.state, {}, nullptr);
  EXPECT_EQ(state_hash(other.state), state_hash(run.state));
}

TEST(StepWork, FastBallsTakeNoLongerThanOthers) {
  for (const SolverKind solver : kSolvers) {
    for (const double speed : {1e6, 1e8}) {
      Level level = level_of({"..........", "..........", "##########"});
      level.tuning.solver = solver;
      level.tuning.shared.cell_size = 1;
      level.spawns = {ball({8, 4}, {speed, speed / 8}), ball({60, 4}, {-speed, 0})};
      Steps run(level);
      for (int i = 0; i < 3; ++i) run.step();
      for (const Body& body : run.state.bodies)
        EXPECT_LE(body.box.bottom(), 16.0) << "it is through the floor";
      expect_same_without_record(level, run);
    }
  }
}

// 3000 balls in one place: each ball would be tested against all others, and on World once more for each ball
// that it meets.
TEST(StepWork, AHeapOfThousandsIsStepped) {
  for (const SolverKind solver : kSolvers) {
    Level level = level_of({"..........", "..........", "##########"});
    level.tuning.solver = solver;
    level.spawns.assign(solver == SolverKind::exact ? 20000 : 3000, ball({20.5, 4}));
    Steps run(level);
    run.step();
    EXPECT_TRUE(run.cut_short(1)) << solver_name(solver);
    EXPECT_EQ(run.state.bodies[0].box, (Rect{20.5, 4, 8, 8})) << solver_name(solver);
    expect_same_without_record(level, run);
  }
}

// A long motion along a wall of free lines: the body passes no line, though the step does not reach its goal.
TEST(StepWork, ABodyStopsWhereItsBudgetEnds) {
  Level level;
  level.map = TileMap(1 << 18, 4);  // 2^21 px
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = 0;
  for (int row = 0; row < 4; ++row) level.map.set({(1 << 18) - 1, row}, 1);
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
  level.spawns.assign(4000, ball({8, 8}, {1e8, 0}));
  Steps run(level);
  run.step();
  EXPECT_TRUE(run.cut_short(1));
  EXPECT_FALSE(run.record.paths[0].capped);
  const double x = run.state.bodies[0].box.x;
  EXPECT_GT(x, 1e4);
  EXPECT_LT(x, 1e6);  // 4096 slices of 16 px, and the lines in them
  level.spawns.resize(1);
  Steps alone(level);
  alone.step();
  EXPECT_FALSE(alone.cut_short(1));
  EXPECT_EQ(alone.state.bodies[0].box.right(), ((1 << 18) - 1) * 8.0) << "the wall";
}

// Large bodies deep in ground of many lines, with many possible ways out.
TEST(StepWork, LargeBodiesInsideTheGroundAreStepped) {
  Level level;
  level.map = TileMap(200, 200);
  level.tuning.solver = SolverKind::exact;
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{1});
  level.tile_shapes[1] = {.kind = TileShape::Kind::profile, .heights = {0, 8, 1, 7, 2, 6, 3, 5, 0}};
  Spawn large = ball({300, 300});
  large.size = {512, 512};
  level.spawns = {large};
  Steps alone(level);
  alone.step();
  EXPECT_FALSE(alone.cut_short(1));
  level.spawns.assign(8000, large);
  level.tuning.shared.bodies = 0;
  Steps many(level);
  many.step();
  EXPECT_TRUE(many.cut_short(1));
}

// Counts everything that all bodies test in a step. The last body may exceed the limit by what it tests at
// once.
void expect_bounded(const char* what, Level level) {
  for (const SolverKind solver : kSolvers) {
    level.tuning.solver = solver;
    Steps run(level);
    for (int i = 0; i < 2; ++i) {
      run.step();
      EXPECT_GT(run.record.work, 0) << what << ", " << solver_name(solver);
      EXPECT_LE(run.record.work, kMaxStepWork + kMaxBodyWork) << what << ", " << solver_name(solver);
    }
    expect_same_without_record(level, run);
  }
}

Level many(int bodies, double side, double speed) {
  Level level = level_of({"#.........", "..........", "##########"});
  level.map = TileMap(120, 60);
  for (int i = 0; i < 120; ++i) level.map.set({i, 59 - i % 7}, 1);
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
  for (int i = 0; i < bodies; ++i) {
    Spawn spawn =
        ball({i * 7 % 900 + 0.5, i * 11 % 300 + 0.25}, {i % 2 == 0 ? speed : -speed, speed / (i % 5 + 1)});
    if (side > 0) spawn.size = {side, side};
    level.spawns.push_back(spawn);
  }
  return level;
}

TEST(StepWork, OfManyFastCollidingBallsIsBounded) {
  const Level level = many(9000, 0, 4096);
  expect_bounded("fast balls", level);
  Level exact = level;
  exact.tuning.solver = SolverKind::exact;
  Steps run(exact);
  run.step();
  EXPECT_TRUE(run.cut_short(1)) << "its way is past more bodies than it may look at";
  EXPECT_EQ(run.state.bodies[0].box, (Rect{0.5, 0.25, 8, 8}));
}

TEST(StepWork, OfManyHugeFastBodiesIsBounded) {
  for (const double blocks : {0, 1}) {
    Level level = many(1500, 1024, 1e6);
    level.tuning.shared.bodies = blocks;
    expect_bounded("huge bodies", level);
  }
}

TEST(StepWork, OfAHeapAndOfTwoFastBallsIsBounded) {
  Level heap = many(1, 0, 0);
  heap.spawns.resize(5000, heap.spawns.front());
  expect_bounded("a heap", heap);
  Level two = many(2, 0, 1e6);
  two.tuning.shared.cell_size = 1;
  expect_bounded("two fast balls", two);
}

TEST(StepWork, OfPartsOfAStepIsBounded) {
  Level level = many(3000, 200, 60);
  level.tuning.shared.bodies = 0;
  level.tuning.exact.substeps = 64;
  level.tuning.exact.max_passes = 16;
  expect_bounded("parts", level);
}

// A box at rest counts like any other, as a solver may step states in any order.
TEST(StepWork, DoesNotDependOnTheStepsBefore) {
  Level level = many(300, 0, 0);
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = 0;
  Steps run(level);
  for (int i = 0; i < 40; ++i) run.step();
  const State state = run.state;
  run.step();
  State again = state;
  StepRecord record;
  make_solver(run.scene)->step(again, {}, &record);
  EXPECT_EQ(record.work, run.record.work);
}

TEST(StepWork, EveryTestOfOtherBodiesIsCounted) {
  BodyGrid grid;
  std::vector<Body> bodies(1000);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].box = {100.0 * static_cast<double>(i), 0, i % 2 == 0 ? 8.0 : 1024.0, 8};
  grid.synchronise(bodies);
  std::vector<std::uint32_t> found;
  std::int64_t left = 1000;
  EXPECT_TRUE(grid.near({0, 0, 8, 8}, 1, left, found)) << "a few cells";
  EXPECT_EQ(found, (std::vector<std::uint32_t>{0}));
  EXPECT_LT(left, 1000 - 500 / 8) << "and a list of all large ones";
  left = 1000;
  EXPECT_FALSE(grid.near({-1e5, -1e5, 2e5, 2e5}, 1, left, found)) << "all bodies are on this way";
  EXPECT_EQ(left, 0);
  EXPECT_TRUE(found.empty());
  left = 100'000;
  EXPECT_TRUE(grid.near({-1e5, -1e5, 2e6, 2e6}, 1, left, found));
  EXPECT_EQ(found.size(), 999u) << "all but the one that asks";
  EXPECT_LE(left, 100'000 - 1000);
  EXPECT_GT(grid.place(0, {5000, 0, 8, 8}), 0);
}

TEST(StepWork, IsTold) {
  Level level = level_of({"..........", "..........", "##########"});
  level.tuning.solver = SolverKind::exact;
  level.spawns.assign(20000, ball({20, 4}));
  Steps run(level);
  run.step();
  Frame frame;
  frame.scene = run.scene;
  frame.state = run.state;
  frame.record = run.record;
  EXPECT_EQ(measure(Metric::cut_short, frame, run.state.bodies[0]), 1);
  run.state.bodies.resize(1);
  StepRecord record;
  record.paths = {run.record.paths[0]};
  EXPECT_EQ(trace_line(run.state, &record).substr(trace_line(run.state, &record).find("\"contacts\"")),
            R"("contacts":[],"cut_short":[1]})");
  record.paths[0].cut_short = false;
  EXPECT_EQ(trace_line(run.state, &record).find("cut_short"), std::string::npos);
  record.paths[0].capped = true;
  EXPECT_NE(trace_line(run.state, &record).find(R"("contacts":[],"capped":[1]})"), std::string::npos);
  EXPECT_EQ(trace_line(run.state, &record, false).find("capped"), std::string::npos);
}

TEST(StepWork, OfAWorldAloneIsBounded) {
  World world(1);
  const ItemId mover = world.add({0, 0, 4, 4});
  world.add({1e7, 0, 4, 4});
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(mover, {1e8, 0}, hits), (Vec2{1e7 - 4, 0}));
  EXPECT_FALSE(world.gave_up());

  World heap;
  for (int i = 0; i < 3000; ++i) heap.add({0.001 * i, 0.002 * i, 80, 80});
  const ItemId deep = heap.add({10, 10, 8, 8});
  heap.set_most_tests(100'000);
  World::GroupResponses crosses;
  crosses.fill(Response::cross);
  EXPECT_EQ(heap.move(deep, {12, 11}, crosses, hits), (Vec2{10, 10}));
  EXPECT_TRUE(heap.gave_up());
  EXPECT_TRUE(hits.empty());
  const auto cross = [](ItemId, ItemId) { return Response::cross; };
  EXPECT_EQ(heap.check(deep, {12, 11}, cross, hits), (Vec2{10, 10}));
  EXPECT_TRUE(heap.gave_up());
  EXPECT_EQ(heap.check(
                deep, {12, 11}, [](ItemId, ItemId) { return Response::ignore; }, hits),
            (Vec2{12, 11}));
  EXPECT_FALSE(heap.gave_up());
}

}  // namespace talus::step_work_test
