// The exact solver: balls that move as in the article, players, and that equal arguments give equal results.

#include "sim/exact_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include <talus/formats/format.h>
#include "level_picture.h"
#include "paths.h"
#include "sim/exact_mover.h"

namespace talus::exact_solver_test {

Level exact_level(std::initializer_list<std::string_view> rows) {
  Level level = level_of(rows);
  level.tuning.solver = SolverKind::exact;
  return level;
}

Spawn player_at(double x, double y) {
  Spawn spawn;
  spawn.position = {x, y};
  spawn.kind = BodyKind::player;
  return spawn;
}

// Steps a level, and keeps the records of the last step.
struct Play {
  explicit Play(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        state(initial_state(*scene)) {}
  void step(const Input& input = {}, int times = 1) {
    for (int i = 0; i < times; ++i) solver->step(state, input, &record);
  }
  const Body& body() const { return state.bodies.front(); }

  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State state;
  StepRecord record;
};

Input keys(bool left, bool right, bool jump = false) {
  Input input;
  input.left = left;
  input.right = right;
  input.jump = jump;
  return input;
}
const Input kRight = keys(false, true);
const Input kLeft = keys(true, false);

TEST(ExactSolver, BallsOnFlatGroundMoveAsInTheArticle) {
  Level level = level_of({"#........#",  //
                          "#o...o...#",  //
                          "#........#",  //
                          "##########"});
  Spawn thrown;
  thrown.position = {40, 2};
  thrown.velocity = {3.25, -1.5};
  level.spawns.push_back(thrown);
  level.tuning.shared.bodies = 0;
  Play article(level);
  level.tuning.solver = SolverKind::exact;
  Play exact(level);
  for (int frame = 1; frame <= 300; ++frame) {
    article.step();
    exact.step();
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(exact.state.bodies[i].velocity, article.state.bodies[i].velocity) << frame << " body " << i;
      EXPECT_NEAR(exact.state.bodies[i].box.x, article.state.bodies[i].box.x, 1e-12) << frame;
      EXPECT_NEAR(exact.state.bodies[i].box.y, article.state.bodies[i].box.y, 1e-12) << frame;
    }
  }
}

TEST(ExactSolver, ABallBouncesOnTheLineOfASlopeByItsNormal) {
  Level level = exact_level({"......",  //
                             ".o....",  //
                             "./-...",  //
                             "######"});
  Play run(level);
  bool met = false;
  for (int frame = 0; frame < 60 && !met; ++frame) {
    run.step();
    if (run.record.contacts.empty()) continue;
    const ContactRecord& contact = run.record.contacts.front();
    met = true;
    // The right corner touches the line from (8, 24) to (24, 16).
    const double right = contact.touch.x + 8;
    EXPECT_EQ(contact.touch.y + 8, 16 + (24 - right) / 2);
    EXPECT_DOUBLE_EQ(contact.normal.x, -1 / std::sqrt(5));
    EXPECT_DOUBLE_EQ(contact.normal.y, -2 / std::sqrt(5));
    EXPECT_LT(run.body().velocity.x, 0);
    ASSERT_TRUE(contact.slope);
    EXPECT_EQ(contact.slope->floor_y, contact.touch.y + 8);
  }
  EXPECT_TRUE(met);
}

TEST(ExactSolver, PassesOverASlopeBetweenFloorsWithoutAJolt) {
  Level level = exact_level({"..........",  //
                             "..........",  //
                             "...../-###",  //
                             "##########"});
  level.spawns.push_back(player_at(4, 16));
  Play run(level);
  double x = 4;
  for (int frame = 0; frame < 40; ++frame) {
    run.step(kRight);
    const Body& body = run.body();
    EXPECT_GT(body.box.x, x) << frame;
    EXPECT_TRUE(body.gait.grounded) << frame;
    x = body.box.x;
    const double centre = x + 4;
    const double floor = centre <= 40 ? 24 : centre >= 56 ? 16 : 24 - (centre - 40) / 2;
    EXPECT_NEAR(body.box.bottom(), floor, 1e-12) << frame;
  }
  EXPECT_GT(x, 52);
}

TEST(ExactSolver, APlayerRunsJumpsAndLands) {
  Level level = exact_level(
      {"............", "............", "............", "............", "............", "############"});
  level.spawns.push_back(player_at(16, 32));
  Play run(level);
  run.step({}, 2);
  EXPECT_TRUE(run.body().gait.grounded);
  EXPECT_EQ(run.body().box.y, 32);
  run.step(kRight, 10);
  EXPECT_EQ(run.body().velocity.x, level.tuning.player.run_speed);
  run.step({}, 10);
  EXPECT_EQ(run.body().velocity.x, 0);

  double full = 32, cut = 32;
  const Input jump = keys(false, false, true);
  for (int i = 0; i < 60; ++i) {
    run.step(jump);
    full = std::min(full, run.body().box.y);
  }
  EXPECT_TRUE(run.body().gait.grounded) << "the key is held: no second jump";
  EXPECT_EQ(run.body().box.y, 32);
  run.step();
  for (int i = 0; i < 60; ++i) {
    run.step(i < 3 ? jump : Input{});
    cut = std::min(cut, run.body().box.y);
  }
  EXPECT_LT(full, cut) << "a jump that is let go is lower";
  EXPECT_LT(cut, 30);
}

TEST(ExactSolver, APlayerMayJumpForAFewFramesAfterTheLedge) {
  Level level =
      exact_level({"..........", "..........", "..........", "###.......", "..........", ".........."});
  level.spawns.push_back(player_at(10, 16));
  for (const int late : {2, 6, 7}) {
    Play run(level);
    while (run.body().gait.grounded || run.state.frame < 2) {
      run.step(kRight);
      ASSERT_LT(run.state.frame, 60);
    }
    run.step(kRight, late - 1);
    run.step(keys(false, true, true));
    EXPECT_EQ(run.body().velocity.y < 0, late <= 6) << late;
  }
}

TEST(ExactSolver, WalksDownASlopeWithoutLeavingIt) {
  Level level = exact_level({"............",   //
                             "............",   //
                             "###\\-.......",  //
                             "############"});
  level.spawns.push_back(player_at(12, 8));
  level.tuning.player.run_speed = 3;
  Play run(level);
  for (int frame = 0; frame < 30 && run.body().box.x < 60; ++frame) {
    run.step(kRight);
    EXPECT_TRUE(run.body().gait.grounded) << frame;
  }
  EXPECT_EQ(run.body().box.bottom(), 24);
}

TEST(ExactSolver, SurfaceSpeedIsMeasuredAlongTheSlope) {
  Level level = exact_level({"..............",  //
                             "..............",  //
                             "...../-#######",  //
                             "##############"});
  level.spawns.push_back(player_at(38, 21));
  level.tuning.player.surface_speed = 1;
  Play run(level);
  run.step(kRight, 8);
  const double before = run.body().box.x;
  run.step(kRight);
  EXPECT_NEAR(run.body().box.x - before, 1.5 * 2 / std::sqrt(5), 1e-12);
}

TEST(ExactSolver, SteepGroundStopsAWalk) {
  Level level = exact_level({"......", "......", "..#...", "######"});
  level.tile_shapes[6] = {TileShape::Kind::slope, TileShape::Side::floor, false, 1, {0, 16}};
  level.map.set({2, 2}, 6);
  level.map.set({3, 2}, 1);
  level.map.set({3, 1}, 1);
  level.spawns.push_back(player_at(2, 16));
  for (const double steepest : {2.0, std::nextafter(2.0, 0.0)}) {
    level.tuning.exact.steepest = steepest;
    Play run(level);
    run.step(kRight, 30);
    EXPECT_EQ(run.body().box.bottom() < 20, steepest == 2.0) << steepest;
  }
}

TEST(ExactSolver, OneWayTilesStopOnlyFallingBodies) {
  Level level = exact_level({"...", "...", "...", "...", "..."});
  level.tile_shapes[6] = {TileShape::Kind::solid, TileShape::Side::floor, true, 1, {}};
  for (int x = 0; x < 3; ++x) level.map.set({x, 2}, 6);
  Spawn ball;
  ball.position = {8, 28};
  ball.velocity = {0, -6};
  level.spawns.push_back(ball);
  Play run(level);
  double highest = 28;
  for (int frame = 0; frame < 200; ++frame) {
    run.step();
    highest = std::min(highest, run.body().box.y);
  }
  EXPECT_LT(highest, 8) << "it rose through the platform";
  EXPECT_EQ(run.body().box.bottom(), 16) << "and came to rest on it";
}

TEST(ExactSolver, ABodyInTheGroundLeavesByTheShortestWay) {
  Level level = exact_level({"....", ".##.", ".##.", "...."});
  Spawn ball;
  ball.position = {0.25, 10};
  level.spawns.push_back(ball);
  Play run(level);
  run.step();
  EXPECT_EQ(run.body().box.x, 0);
}

TEST(ExactSolver, ReboundKeepsTheEnergyOfAPerfectBounce) {
  Level level = exact_level({"...", "...", "...", "...", "...", "...", "...", "..."});
  for (int x = 0; x < 3; ++x) level.map.set({x, 7}, 1);
  level.tuning.exact.gravity = 0.25;
  level.tuning.exact.rebound = 1;
  level.tuning.shared.floor_bounce = 1;
  level.tuning.shared.floor_grip = 1;
  Spawn ball;
  ball.position = {8, 11};
  level.spawns.push_back(ball);
  Play run(level);
  const auto energy = [&] {
    const double v = run.body().velocity.y + 0.125;
    return v * v / 2 + 0.25 * (48 - run.body().box.y);
  };
  const double start = energy();
  for (int i = 0; i < 100'000; ++i) {
    run.step();
    ASSERT_NEAR(energy(), start, 1e-9) << i;
  }
}

TEST(ExactSolver, UsesOnlyTheFeaturesOfItsScene) {
  Level level = exact_level({"o.", "##"});
  EXPECT_EQ(compile_scene(level).features, SceneFeatures());
  level.map.set({1, 0}, 2);
  EXPECT_TRUE(compile_scene(level).features.pairs);
  level.spawns.push_back(player_at(0, 0));
  EXPECT_TRUE(compile_scene(level).features.players);
}

TEST(ExactSolver, AFeatureThatIsNotUsedChangesNothing) {
  const auto picture = {std::string_view("#..........o....."), std::string_view("#...o......#####."),
                        std::string_view("#......o........."), std::string_view("#################")};
  Level plain = exact_level(picture);
  Level rich = exact_level(picture);
  rich.map.set({16, 0}, 3);
  rich.curves.push_back({"arc", {Arc{{120, 8}, 8, 112, 128, true}}, {}});
  Play a(plain), b(rich);
  for (int frame = 0; frame < 200; ++frame) {
    a.step();
    b.step();
    ASSERT_EQ(a.state.bodies, b.state.bodies) << frame;
  }
}

TEST(ExactSolver, BallsBlockOneAnotherByCellOrder) {
  Level level = exact_level({".o.",  //
                             ".o.",  //
                             "...",  //
                             "###"});
  Play run(level);
  run.step({}, 300);
  EXPECT_EQ(run.state.bodies[1].box.bottom(), 24);
  EXPECT_EQ(run.state.bodies[0].box.bottom(), 16) << "it rests on the other";
}

TEST(ExactSolver, RecordingAndRestartingChangeNothing) {
  Level level = exact_level({"#....o...#", "#.o../-..#", "#/-......#", "##########"});
  level.spawns.push_back(player_at(56, 8));
  Play recorded(level);
  State alone = recorded.state, fresh = recorded.state;
  const auto solver = make_solver(recorded.scene);
  for (int frame = 0; frame < 120; ++frame) {
    const Input input = keys(frame % 40 < 20, frame % 40 >= 20, frame % 30 < 10);
    recorded.step(input);
    solver->step(alone, input, nullptr);
    fresh = step(*recorded.scene, fresh, input);
    ASSERT_EQ(recorded.state, alone) << frame;
    ASSERT_EQ(recorded.state, fresh) << frame;
  }
}

TEST(ExactSolver, SinglePrecisionIsNearDoublePrecision) {
  Level level = exact_level({"#....o...#", "#.o../-..#", "#/-......#", "##########"});
  Play exact(level);
  level.tuning.exact.single_precision = 1;
  Play single(level);
  EXPECT_EQ(single.scene->ground, nullptr);
  exact.step({}, 10);
  single.step({}, 10);
  EXPECT_NE(exact.state, single.state);
  EXPECT_NEAR(exact.body().box.y, single.body().box.y, 1e-3);
  EXPECT_EQ(single.body().box.y, static_cast<float>(single.body().box.y));
}

// A slope of three tiles has three pieces. Beyond the end of the first one, the box is on the next one,
// higher up.
TEST(ExactSolver, ABoxIsNotPutBackOnAPieceThatItSlidPast) {
  TerrainSource source;
  source.width = 10, source.height = 4;
  std::vector<TileNumber> cells(40);
  cells[2 * 10 + 6] = 1;
  source.cells = cells;
  source.shapes[1] = {.kind = TileShape::Kind::slope, .tiles = 3, .heights = {0.75, 0}};  // from (48,23.25)
  const BasicTerrain<float> ground(source);
  Moving<float> body{{56.851639f, 20.089113f, 8, 3.4375f}, {}};
  const auto slide = [](const Contact<float>& contact, BasicVec2<float> motion) {
    return slide_along(contact.normal, motion * (1 - contact.t));
  };
  Mover<float>(ground, {}, 8).move(body, {-0.86466753f, 0.17298125f}, slide, [](auto&&...) { return true; });
  ASSERT_LT(body.box.x, 56);
  EXPECT_LE(body.box.y + 3.4375f, 23.25f + (body.box.x - 48) / 32 + 0x1p-18f);
}

TEST(ExactSolver, ARecompiledSceneEqualsACompiledOne) {
  Level level = exact_level({"#....o...#", "#.o../-..#", "#/-......#", "##########"});
  level.spawns.push_back(player_at(56, 8));
  Scene scene = compile_scene(level);
  const std::vector<std::pair<Cell, int>> edits = {
      {{5, 0}, 0}, {{2, 2}, 1}, {{1, 2}, 0}, {{4, 1}, 2}, {{0, 0}, 3}};
  for (const auto& [cell, tile] : edits) {
    level.map.set(cell, static_cast<TileNumber>(tile));
    const Cell changed[] = {cell};
    scene = recompile_scene(scene, level, changed);
    EXPECT_EQ(scene, compile_scene(level)) << cell.x << " " << cell.y;
  }
}

TEST(ExactSolver, UsedUpPassesAreRecorded) {
  Level level = exact_level({"####", "#..#", "####"});
  level.tuning.exact.rebound = 1;
  level.tuning.exact.max_passes = 4;
  level.tuning.shared.wall_bounce = 1;
  level.tuning.shared.fall_speed = 0;
  level.tuning.shared.drift_blend = 0;
  Spawn ball;
  ball.position = {10, 10};
  ball.velocity = {200, 0};
  ball.size = {4, 4};
  level.spawns.push_back(ball);
  Play run(level);
  run.step();
  EXPECT_TRUE(run.record.paths.front().capped);
  EXPECT_EQ(run.record.contacts.size(), 4u);
}

TEST(ExactSolver, AContactWithALevelSideNamesTheWholeTile) {
  for (const Cell cell : {Cell{0, 0}, Cell{1, 0}, Cell{2, 1}}) {
    Level level = exact_level({"....", "....", "....", "...."});
    level.tuning.exact.gravity = 0;
    level.tile_shapes[40] = {
        .kind = TileShape::Kind::profile, .side = TileShape::Side::ceiling, .heights = {4, 4, 4}};
    level.map.set(cell, 40);
    Spawn ball;
    ball.position = {cell.x * 8.0, cell.y * 8.0 + 6};
    ball.velocity = {0, -6};
    level.spawns.push_back(ball);
    Play run(level);
    run.step();
    ASSERT_FALSE(run.record.contacts.empty());
    const Obstacle& other = run.record.contacts[0].other;
    EXPECT_EQ(other.cell, cell);
    EXPECT_EQ(other.box, (Rect{cell.x * 8.0, cell.y * 8.0, 8, 8}));
  }
}

TEST(ExactSolver, LeftAndRightAreMirrorImages) {
  Level level = exact_level({"................",   //
                             "................",   //
                             "..../-##\\-......",  //
                             "################"});
  level.spawns.push_back(player_at(52, 0));
  Play right(level), left(level);
  for (int frame = 0; frame < 40; ++frame) {
    right.step(kRight);
    left.step(kLeft);
    ASSERT_EQ(right.body().box.x + left.body().box.x, 104) << frame;
    ASSERT_EQ(right.body().box.y, left.body().box.y) << frame;
  }
}

// Pinned: the same on every compiler and at every level of optimisation.
TEST(ExactSolver, EndsWithThePinnedHash) {
  Level level = load_level(source_path("tests/golden/article/six.lua")).value().level;
  level.tuning.solver = SolverKind::exact;
  level.spawns.push_back(player_at(60, 20));
  const Scene scene = compile_scene(level);
  const auto solver = make_solver(std::make_shared<const Scene>(scene));
  State state = initial_state(scene);
  for (int i = 0; i < 600; ++i) solver->step(state, i / 40 % 2 == 0 ? kRight : kLeft);
  EXPECT_EQ(state_hash(state), 11773478746611004933u);
}

}  // namespace talus::exact_solver_test
