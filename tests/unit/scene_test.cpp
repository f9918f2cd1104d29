// Compiling a level: which boxes it makes, and in which order.

#include "sim/scene.h"

#include <gtest/gtest.h>

#include "level_text.h"

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

TEST(Scene, ASlopeIsOneBoxOfTwoTilesAndItsSecondHalfIsDecoration) {
  const Scene scene = compile_scene(level_of({"..\\-"}));
  ASSERT_EQ(scene.items.size(), 1u);
  EXPECT_EQ(scene.items[0].box, (Rect{16, 0, 16, 8}));
  EXPECT_EQ(scene.items[0].role, TileRole::down_slope);
}

TEST(Scene, TheSizeOfASlopeIsTuning) {
  Level level = level_of({"/-"});
  level.tuning.article.slope_width = 24;
  level.tuning.article.slope_height = 4;
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

}  // namespace talus::scene_test
