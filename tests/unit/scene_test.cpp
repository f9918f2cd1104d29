// Compiling a level: the boxes that it makes, and their order.

#include <talus/sim/scene.h>

#include <gtest/gtest.h>

#include <talus/level/ground.h>
#include <talus/sim/solver.h>
#include "level_picture.h"

namespace talus::scene_test {

std::string picture_of(const Scene& scene) {
  std::string text;
  for (const SceneItem& item : scene.items) {
    const char c = item.role == TileRole::solid        ? '#'
                   : item.role == TileRole::up_slope   ? '/'
                   : item.role == TileRole::down_slope ? '\\'
                                                       : 'o';
    text += c + std::to_string(item.cell.x) + "," + std::to_string(item.cell.y) + " ";
  }
  return text;
}

TEST(Scene, ItemsComeColumnByColumn) {
  const Scene scene = compile_scene(level_of({"#o.",  //
                                              "..#",  //
                                              "#/-"}));
  EXPECT_EQ(picture_of(scene), "#0,0 #0,2 o1,0 /1,2 #2,1 ");
}

TEST(Scene, ASlopeIsOneBoxOfTwoTiles) {
  const Scene scene = compile_scene(level_of({"..\\-"}));
  ASSERT_EQ(scene.items.size(), 1u);
  EXPECT_EQ(scene.items[0].box, (Rect{16, 0, 16, 8}));
  EXPECT_EQ(scene.items[0].role, TileRole::down_slope);
}

TEST(Scene, TheSizeOfASlopeIsTuning) {
  Level level = level_of({"/-"});
  level.tuning.shared.slope_width = 24;
  level.tuning.shared.slope_height = 4;
  EXPECT_EQ(compile_scene(level).items[0].box, (Rect{0, 0, 24, 4}));
}

TEST(Scene, SpawnsFollowTheMap) {
  Level level = level_of({"#o"});
  level.spawns.push_back({"a", {0.5, -3}, {1, 2}, {}});
  const Scene scene = compile_scene(level);
  ASSERT_EQ(scene.items.size(), 3u);
  EXPECT_EQ(scene.items[2].box, (Rect{0.5, -3, 8, 8}));
  EXPECT_EQ(scene.items[2].velocity, (Vec2{1, 2}));
  EXPECT_EQ(scene.items[2].origin(), (BodyOrigin{{0, 0}, 0}));
}

TEST(Scene, RolesFollowTheUsersFlags) {
  Level level = level_of({"#o/"});
  level.roles = {.solid = 2, .ball = FlagRoles::kUnused, .up_slope = 0, .down_slope = 1};
  EXPECT_EQ(picture_of(compile_scene(level)), "/0,0 \\1,0 #2,0 ");
}

TEST(Scene, AStraightFloorOfATileIsASlopesBoxOnASolidOne) {
  Level level = level_of({"...", "x.#"});
  level.map.set({0, 1}, 7);
  level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {2, 12}};
  const Scene scene = compile_scene(level);
  ASSERT_EQ(scene.items.size(), 3u);
  EXPECT_EQ(scene.items[0].role, TileRole::up_slope);
  EXPECT_EQ(scene.items[0].box, (Rect{0, 4, 16, 10}));
  EXPECT_EQ(scene.items[1].role, TileRole::solid);
  EXPECT_EQ(scene.items[1].box, (Rect{0, 14, 16, 2}));
  EXPECT_EQ(scene.items[2].cell, (Cell{2, 1}));
}

TEST(Scene, ASpawnHasItsOwnSize) {
  Level level = level_of({"#"});
  level.spawns.emplace_back().size = {12, 14};
  EXPECT_EQ(compile_scene(level).items[1].box, (Rect{0, 0, 12, 14}));
}

TEST(FlagRoles, SolidWinsOverSlopesAndSlopesOverBall) {
  const FlagRoles roles;
  EXPECT_EQ(role_of(0b1111, roles), TileRole::solid);
  EXPECT_EQ(role_of(0b1110, roles), TileRole::up_slope);
  EXPECT_EQ(role_of(0b1010, roles), TileRole::down_slope);
  EXPECT_EQ(role_of(0b0010, roles), TileRole::ball);
  EXPECT_EQ(role_of(0b11110000, roles), TileRole::none);
}

// More than 2 GB of boxes are reported and not made.
TEST(Scene, WithTooMuchGroundForItsSolverHasNone) {
  Level level;
  level.map = TileMap(2048, 1025);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{1});
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
  level.spawns.resize(1);
  level.tuning.solver = SolverKind::exact;
  EXPECT_FALSE(ground_problem(level));
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    level.tuning.solver = solver;
    EXPECT_EQ(ground_problem(level), "has ground of 2099200 boxes, but the solver " +
                                         std::string(solver_name(solver)) +
                                         " can take only 2097152: choose the solver exact");
    EXPECT_EQ(compile_scene(level).items.size(), 1u);
  }
  level.map.set({0, 0}, 0);
  level.map.cells().tiles()[0] = 0;
  std::fill_n(level.map.cells().tiles().begin(), 2048, TileNumber{0});
  EXPECT_FALSE(ground_problem(level));
}

// A few tiles with many heights take as much as a map full of others.
TEST(Scene, GroundIsCountedByTheHeightsOfItsTiles) {
  Level level;
  level.map = TileMap(400, 400);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{1});
  std::vector<double> heights;
  for (int i = 0; i < max_shape_heights({}); ++i) heights.push_back(i % 2 == 0 ? 0 : 8);
  level.tile_shapes[1] = {.kind = TileShape::Kind::profile, .one_way = true, .heights = heights};
  level.spawns.resize(1);
  level.tuning.solver = SolverKind::bump;
  EXPECT_EQ(
      ground_problem(level),
      "has ground of 10240000 boxes, but the solver bump can take only 2097152: choose the solver exact");
  EXPECT_EQ(compile_scene(level).items.size(), 1u);
  level.tuning.solver = SolverKind::exact;
  EXPECT_EQ(ground_problem(level),
            "has ground of 20480000 lines, but the solver exact can take only 16777216: use fewer or simpler "
            "slopes, profiles and polygons");
  const Scene scene = compile_scene(level);
  EXPECT_FALSE(scene.ground->has_pieces());

  // Edits that remove the ground, and add it again.
  Level edited = level;
  edited.map = TileMap(400, 400);
  edited.map.set({3, 3}, 1);
  std::vector<Cell> changed;
  for (Cell c; c.y < 400; ++c.y)
    for (c.x = 0; c.x < 400; ++c.x) changed.push_back(c);
  EXPECT_FALSE(ground_problem(edited));
  const Scene fewer = recompile_scene(scene, edited, changed);
  EXPECT_TRUE(fewer == compile_scene(edited));
  EXPECT_TRUE(fewer.ground->has_pieces());
  EXPECT_EQ(fewer.ground_lines, 128u);
  EXPECT_FALSE(recompile_scene(fewer, level, changed).ground->has_pieces());
}

// Cells far smaller than the boxes would take gigabytes. The solver uses larger cells for such boxes, and
// nothing else changes.
TEST(Scene, LargeBodiesInSmallCellsAreStepped) {
  Level level = level_of({"....", "####"});
  Spawn large;
  large.position = {0, -1100};
  large.size = {1024, 1024};
  level.spawns.assign(20, large);
  level.tuning.shared.bodies = 1;
  level.tuning.shared.cell_size = 1;
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    level.tuning.solver = solver;
    State small = initial_state(compile_scene(level));
    small = step(compile_scene(level), small, {});
    Level other = level;
    other.tuning.shared.cell_size = 64;
    EXPECT_EQ(state_hash(small),
              state_hash(step(compile_scene(other), initial_state(compile_scene(other)), {})));
  }
}

}  // namespace talus::scene_test
