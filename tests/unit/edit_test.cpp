// Edits: applying, reverting, merging and rebasing them.
#include "level/edit.h"

#include <gtest/gtest.h>

namespace talus::edit_test {

Edit cells(std::vector<CellChange> changes) {
  Edit edit{"Paint tiles", {}};
  edit.changes.assign(changes.begin(), changes.end());
  return edit;
}

const CellChange& cell_change(const Edit& edit, std::size_t index) {
  return std::get<CellChange>(edit.changes.at(index));
}

// One change of each kind.
Edit one_of_each(const Level& level) {
  Tuning tuning = level.tuning;
  tuning.shared.fall_speed = 3;
  FlagRoles roles = level.roles;
  roles.ball = FlagRoles::kUnused;
  TileMap map(3, 2);
  map.set({2, 1}, 9);
  Spawn spawn;
  spawn.name = "hero";
  const TileShape solid{.kind = TileShape::Kind::solid};
  const LevelCurve curve{"hill", {Segment{{0, 0}, {8, 8}}, Curve::Faces::both}, ""};
  return {"Everything",
          {PixelChange{SheetId::sprites, 255, 63, 0, 15}, FlagsChange{SheetId::tiles, 0, 0, 255},
           ColorChange{3, level.palette[3], {1, 2, 3}}, BackgroundChange{{}, Rgba{1, 2, 3, 4}},
           FlagNameChange{7, "", "water"}, FlagFieldsChange{{}, {{"ground", 4, 2, {}, ""}}},
           RolesChange{level.roles, roles}, TileShapeChange{7, {}, solid}, FlagShapeChange{6, {}, solid},
           CurvesChange{{}, {curve}}, TuningChange{level.tuning, tuning}, SpawnsChange{{}, {spawn}},
           MapChange{level.map, map}}};
}

TEST(Edit, ChangesEveryPartOfALevel) {
  Level level;
  apply_edit(level, one_of_each(level));
  EXPECT_EQ(level.sheet(SheetId::sprites).images[255][63], 15);
  EXPECT_EQ(level.sheet(SheetId::tiles).flags[0], 255);
  EXPECT_EQ(level.palette[3], (Rgb{1, 2, 3}));
  EXPECT_EQ(level.background, (Rgba{1, 2, 3, 4}));
  EXPECT_EQ(level.flag_names[7], "water");
  ASSERT_EQ(level.flag_fields.size(), 1u);
  EXPECT_EQ(level.flag_fields[0].name, "ground");
  EXPECT_EQ(level.roles.ball, FlagRoles::kUnused);
  EXPECT_EQ(level.tile_shapes[7].kind, TileShape::Kind::solid);
  EXPECT_EQ(level.flag_shapes[6].kind, TileShape::Kind::solid);
  ASSERT_EQ(level.curves.size(), 1u);
  EXPECT_EQ(level.curves[0].name, "hill");
  EXPECT_EQ(level.tuning.shared.fall_speed, 3);
  ASSERT_EQ(level.spawns.size(), 1u);
  EXPECT_EQ(level.spawns[0].name, "hero");
  EXPECT_EQ(level.map.width(), 3);
  EXPECT_EQ(level.map.at({2, 1}), 9);
}

TEST(Edit, RevertGivesTheLevelBack) {
  Level level;
  const Edit edit = one_of_each(level);
  apply_edit(level, edit);
  EXPECT_FALSE(level == Level());
  revert_edit(level, edit);
  EXPECT_TRUE(level == Level());
}

TEST(Edit, MergeKeepsTheFirstBeforeAndTheLastAfter) {
  Edit edit = cells({{{1, 1}, 0, 5}, {{2, 1}, 0, 5}});
  merge_edit(edit, cells({{{2, 1}, 5, 7}, {{3, 1}, 0, 7}}));
  ASSERT_EQ(edit.changes.size(), 3u);
  EXPECT_EQ(cell_change(edit, 1).cell, (Cell{2, 1}));
  EXPECT_EQ(cell_change(edit, 1).before, 0);
  EXPECT_EQ(cell_change(edit, 1).after, 7);
  EXPECT_EQ(cell_change(edit, 2).cell, (Cell{3, 1}));
}

TEST(Edit, MergeDropsChangesThatCancelOut) {
  Edit edit = cells({{{1, 1}, 0, 5}, {{2, 1}, 0, 5}, {{3, 1}, 0, 5}});
  merge_edit(edit, cells({{{1, 1}, 5, 0}, {{3, 1}, 5, 6}}));
  ASSERT_EQ(edit.changes.size(), 2u);
  EXPECT_EQ(cell_change(edit, 0).cell, (Cell{3, 1}));
  EXPECT_EQ(cell_change(edit, 0).after, 6);
  EXPECT_EQ(cell_change(edit, 1).cell, (Cell{2, 1}));
  merge_edit(edit, cells({{{2, 1}, 5, 0}, {{3, 1}, 6, 0}}));
  EXPECT_TRUE(edit.empty());
}

TEST(Edit, MergeKeepsPlacesOfDifferentKindsApart) {
  Level level;
  level.map = TileMap(4, 4);
  Edit edit{"Mixed",
            {PixelChange{SheetId::tiles, 1, 0, 0, 1}, PixelChange{SheetId::sprites, 1, 0, 0, 1},
             PixelChange{SheetId::tiles, 1, 1, 0, 1}, FlagsChange{SheetId::tiles, 1, 0, 1},
             FlagsChange{SheetId::sprites, 1, 0, 1}, CellChange{{1, 0}, 0, 1}, CellChange{{0, 1}, 0, 1},
             FlagNameChange{1, "", "a"}, ColorChange{1, level.palette[1], {}},
             TileShapeChange{1, {}, {.tiles = 2}}, TileShapeChange{2, {}, {.tiles = 2}},
             FlagShapeChange{1, {}, {.tiles = 2}}, FlagShapeChange{2, {}, {.tiles = 2}}}};
  const Edit same = edit;
  edit = {"Mixed", {}};
  merge_edit(edit, same);
  EXPECT_EQ(edit.changes.size(), same.changes.size());
}

// Single cells, and the whole map before and after a change, name the same places in two ways.
TEST(Edit, MergeFoldsCellsIntoTheWholeMap) {
  Level level;
  level.map = TileMap(2, 1);
  const Level original = level;
  Edit edit = cells({{{0, 0}, 0, 5}});
  apply_edit(level, edit);
  TileMap wide(3, 1);
  wide.set({0, 0}, 5);
  for (const Edit& next : {Edit{"Resize", {MapChange{level.map, wide}}}, cells({{{2, 0}, 0, 8}})}) {
    apply_edit(level, next);
    merge_edit(edit, next);
  }
  const Level final = level;
  ASSERT_EQ(edit.changes.size(), 1u);
  revert_edit(level, edit);
  EXPECT_TRUE(level == original);
  apply_edit(level, edit);
  EXPECT_TRUE(level == final);
  EXPECT_EQ(level.map.at({2, 0}), 8);

  const Edit back{"Resize", {MapChange{level.map, original.map}}};
  merge_edit(edit, back);
  EXPECT_TRUE(edit.empty());
}

TEST(Edit, ShapesAreMergedAndRebased) {
  const TileShape solid{.kind = TileShape::Kind::solid}, wide{.tiles = 2};
  Edit edit{"Shape", {TileShapeChange{7, {}, solid}}};
  merge_edit(edit, {"Shape", {TileShapeChange{7, solid, wide}, TileShapeChange{8, {}, solid}}});
  ASSERT_EQ(edit.changes.size(), 2u);
  EXPECT_EQ(std::get<TileShapeChange>(edit.changes[0]).after, wide);
  Level level;
  level.tile_shapes[7] = solid;
  level.tile_shapes[8] = solid;
  rebase_edit(level, edit);
  ASSERT_EQ(edit.changes.size(), 1u) << "tile 8 has that shape already";
  EXPECT_EQ(std::get<TileShapeChange>(edit.changes[0]).before, solid);
}

TEST(Edit, RebaseAdaptsAnEditToAnotherLevel) {
  Level level;
  level.map = TileMap(2, 1);
  level.map.set({0, 0}, 3);
  level.map.set({1, 0}, 4);
  Edit edit = cells({{{0, 0}, 0, 4}, {{1, 0}, 0, 4}, {{2, 0}, 0, 4}});
  rebase_edit(level, edit);
  ASSERT_EQ(edit.changes.size(), 1u) << "(1, 0) is 4 already, and (2, 0) no longer exists";
  EXPECT_EQ(cell_change(edit, 0).before, 3);
  EXPECT_EQ(cell_change(edit, 0).after, 4);
}

}  // namespace talus::edit_test
