// Placing, changing and removing bodies, and finding the one under the mouse.
#include "edit/spawn_tools.h"

#include <gtest/gtest.h>

#include <talus/level/ground.h>
#include "level/followed_spawn.h"
#include "level/single_change.h"

namespace talus::spawn_tools_test {

Spawn spawn_at_x(double x) {
  Spawn spawn;
  spawn.position = {x, 0};
  return spawn;
}

TEST(SpawnTools, AddChangeAndRemoveCanBeUndone) {
  Level level;
  const Edit added = add_spawn(level, spawn_at_x(8));
  apply_edit(level, added);
  apply_edit(level, add_spawn(level, spawn_at_x(16)));
  ASSERT_EQ(level.spawns.size(), 2u);
  EXPECT_EQ(level.spawns[1].position.x, 16);
  Spawn player = level.spawns[0];
  player.kind = BodyKind::player;
  const Edit changed = change_spawn(level, 0, player, "Make a body a player");
  apply_edit(level, changed);
  EXPECT_EQ(level.spawns[0].kind, BodyKind::player);
  const Edit removed = remove_spawn(level, 0);
  apply_edit(level, removed);
  ASSERT_EQ(level.spawns.size(), 1u);
  EXPECT_EQ(level.spawns[0].position.x, 16);
  revert_edit(level, removed);
  revert_edit(level, changed);
  EXPECT_EQ(level.spawns[0], spawn_at_x(8));
  EXPECT_TRUE(change_spawn(level, 0, level.spawns[0], "").empty());
}

TEST(SpawnTools, ANewPlayerStandsOnTheNearestGround) {
  Level level;
  level.map = TileMap(20, 10);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 12; x < 20; ++x) level.map.set({x, 6}, 1);
  for (int x = 12; x < 16; ++x) level.map.set({x, 5}, 1);
  const auto at = [&](Vec2 place) {
    const Terrain ground = terrain_of(level);
    const Spawn player = player_near(level, &ground, place);
    EXPECT_EQ(player.kind, BodyKind::player);
    return player.position;
  };
  EXPECT_EQ(at({140, 10}), (Vec2{136, 40})) << "below the place";
  EXPECT_EQ(at({10, 10}), (Vec2{96, 32})) << "beside the hole";
  EXPECT_EQ(at({100, 52}), (Vec2{96, 32})) << "out of the ground";
  level.map.cells().tiles().assign(200, 0);
  EXPECT_EQ(at({10, 10}), (Vec2{8, 8})) << "there is no ground";
  EXPECT_EQ(player_near(level, nullptr, {10, 10}).position, (Vec2{8, 8}));
  level.map.cells().tiles().assign(200, 1);
  EXPECT_EQ(at({10, 10}), (Vec2{8, 8})) << "nothing is free";
}

TEST(SpawnTools, TheLastSpawnUnderThePointIsFound) {
  Level level;
  level.spawns = {spawn_at_x(0), spawn_at_x(4), spawn_at_x(40)};
  level.spawns[2].size = {2, 20};
  EXPECT_EQ(spawn_at(level, {2, 2}), 0);
  EXPECT_EQ(spawn_at(level, {6, 2}), 1);
  EXPECT_EQ(spawn_at(level, {12, 2}), -1);  // the right side is outside
  EXPECT_EQ(spawn_at(level, {41, 19}), 2);
  EXPECT_EQ(spawn_at(level, {41, 20}), -1);
}

TEST(SpawnTools, ACopyIsBesideTheBodyOnTheMap) {
  Level level;
  level.map = TileMap(4, 2);
  level.spawns = {spawn_at_x(8)};
  level.spawns[0].name = "hero";
  level.spawns[0].velocity = {1, -2};
  const Edit edit = duplicate_spawn(level, 0);
  EXPECT_EQ(edit.label, "Duplicate a body");
  apply_edit(level, edit);
  ASSERT_EQ(level.spawns.size(), 2u);
  EXPECT_EQ(level.spawns[1].position.x, 16);
  EXPECT_EQ(level.spawns[1].name, "hero");
  EXPECT_EQ(level.spawns[1].velocity, (Vec2{1, -2}));
  level.spawns[0].position.x = 24;
  apply_edit(level, duplicate_spawn(level, 0));
  EXPECT_EQ(level.spawns[2].position.x, 16) << "to the left at the map's end";
}

TEST(SpawnTools, TitlesAreNamesOrKindsWithNumbers) {
  Level level;
  level.spawns = {spawn_at_x(0), spawn_at_x(8)};
  level.spawns[0].name = "hero";
  level.spawns[1].kind = BodyKind::player;
  EXPECT_EQ(title_of_spawn(level, 0), "hero");
  EXPECT_EQ(title_of_spawn(level, 1), "player 2");
}

TEST(SpawnTools, SpawnsAreFollowedAcrossAnEdit) {
  const Spawn a = spawn_at_x(8), b = spawn_at_x(16), c = spawn_at_x(24), other = spawn_at_x(99);
  const auto followed = [](const std::vector<Spawn>& before, const std::vector<Spawn>& after) {
    std::vector<std::optional<int>> now;
    for (int i = 0; i < static_cast<int>(before.size()); ++i) now.push_back(followed_spawn(before, after, i));
    return now;
  };
  using Now = std::vector<std::optional<int>>;
  EXPECT_EQ(followed({a, b, c}, {b, c}), (Now{std::nullopt, 0, 1}));
  EXPECT_EQ(followed({a, b, c}, {a, c}), (Now{0, std::nullopt, 1}));
  EXPECT_EQ(followed({a, b, c}, {a, b}), (Now{0, 1, std::nullopt}));
  EXPECT_EQ(followed({a, c}, {a, b, c}), (Now{0, 2}));
  EXPECT_EQ(followed({a, b, c}, {a, other, c}), (Now{0, 1, 2})) << "a changed body is still the same body";
  EXPECT_EQ(followed({a, a, b}, {a, b}), (Now{0, std::nullopt, 1}))
      << "of two equal bodies the second counts as removed";
  EXPECT_EQ(followed({a, b}, {}), (Now{std::nullopt, std::nullopt}));
}

}  // namespace talus::spawn_tools_test
