// Groups of layers: how what is in them looks, and the edits of them.
#include <gmock/gmock.h>

#include "edit/group_tools.h"
#include "edit/layer_tools.h"
#include "edit/undo_stack.h"
#include "level/merge.h"
#include "level/object_ground.h"
#include "native_text.h"

namespace talus::layer_groups_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::shared_ptr<const MapCells> cells_of(std::vector<TileNumber> tiles) {
  return std::make_shared<const MapCells>(std::move(tiles));
}

// From the back: "sky"; the group "outer" with "hills" and the group "inner" with "trees" and the objects
// "birds"; "front", which is chosen.
Level grouped_level() {
  Level level;
  level.map = TileMap(2, 1);
  level.layers.list = {{.name = "sky", .cells = cells_of({1, 0})},
                       {.name = "hills", .group = 0, .cells = cells_of({0, 2})},
                       {.name = "trees", .opacity = 0.5, .group = 1, .cells = cells_of({3, 0})},
                       {.name = "front"}};
  level.layers.chosen = 3;
  level.objects = {{.name = "birds", .offset = {1, 0}, .group = 1, .place = 3}};
  level.objects[0].objects = {{.position = {8, 0}, .size = {4, 4}}};
  level.layers.groups = {{.name = "outer", .offset = {10, 20}, .tint = {128, 255, 255}},
                         {.name = "inner", .opacity = 0.5, .parallax = {0.5, 2}, .group = 0}};
  return level;
}

void add_text(const Level& level, int depth, std::size_t& next, const std::vector<LayerNode>& nodes,
              std::string& text) {
  while (next < nodes.size() && nodes[next].depth == depth) {
    const LayerNode& node = nodes[next++];
    text += text.empty() || text.ends_with('(') ? "" : " ";
    if (!node.is_group) {
      const auto at = static_cast<std::size_t>(node.layer.index);
      text += node.layer.has_tiles ? level.layers.list[at].name : level.objects[at].name;
      continue;
    }
    text += group_name(level, node.group) + "(";
    add_text(level, depth + 1, next, nodes, text);
    text += ")";
  }
}
// "sky outer(hills inner(trees birds)) front": from the back.
std::string text_of(const Level& level) {
  std::string text;
  std::size_t next = 0;
  add_text(level, 0, next, layer_tree(level, false), text);
  return text;
}

// The layers after an edit. Expects that undo and redo go back and forth.
std::string after(Level level, Edit edit) {
  const Level before = level;
  UndoStack history;
  rebase_edit(level, edit);
  history.push(level, std::move(edit));
  const Level now = level;
  if (history.can_undo()) {
    history.undo(level);
    EXPECT_EQ(level, before);
    history.redo(level);
    EXPECT_EQ(level, now);
  }
  return text_of(now);
}

TEST(LayerGroups, JoinTheLooksOfWhatIsInThem) {
  Level level = grouped_level();
  const LayerLooks trees = shown_looks(level.layers.groups, level.layers.list[2]);
  EXPECT_EQ(trees.opacity, 0.25);
  EXPECT_EQ(trees.offset, (Vec2{10, 20}));
  EXPECT_EQ(trees.parallax, (Vec2{0.5, 2}));
  EXPECT_EQ(trees.tint, (Rgb{128, 255, 255}));
  EXPECT_TRUE(trees.visible);
  EXPECT_FALSE(trees.locked);
  EXPECT_EQ(shown_looks(level.layers.groups, level.objects[0]).offset, (Vec2{11, 20}));
  level.layers.groups[0].visible = false;
  level.layers.groups[0].locked = true;
  level.layers.groups[0].offset = {kMaxLayerOffset, 0};
  level.layers.list[2].offset = {5, 5};
  const LayerLooks hidden = shown_looks(level.layers.groups, level.layers.list[2]);
  EXPECT_FALSE(hidden.visible);
  EXPECT_TRUE(hidden.locked);
  EXPECT_EQ(hidden.offset, (Vec2{kMaxLayerOffset, 5}));
  EXPECT_EQ(shown_looks(level.layers.groups, level.layers.list[0]), LayerLooks());
}

TEST(LayerGroups, ThatAreNotThereCountAsNone) {
  LayerGroups ring = {{.opacity = 0.5, .group = 1}, {.opacity = 0.5, .group = 0}};
  EXPECT_EQ(shown_looks(ring, TileLayer{.group = 7}).opacity, 1);
  EXPECT_EQ(shown_looks(ring, TileLayer{.group = 1}).opacity, 0.25) << "1 is in 0, and 0 in no later one";
}

TEST(LayerGroups, AreBroughtIntoOrder) {
  Level level = grouped_level();
  const Level wanted = level;
  level.layers.groups = {level.layers.groups[1], {.name = "empty"}, level.layers.groups[0]};
  level.layers.groups[0].group = 2;
  level.layers.list[1].group = 2;
  level.layers.list[2].group = level.objects[0].group = 0;
  tidy_groups(level.layers, level.objects);
  EXPECT_EQ(level, wanted);
  level.layers.groups[0].group = 1;  // a ring
  level.layers.list[0].group = 9;
  tidy_groups(level.layers, level.objects);
  EXPECT_EQ(text_of(level), "sky inner(outer(hills) trees birds) front");
}

TEST(LayerGroups, GroundOfObjectsIsWhereItIsDrawn) {
  Level level = grouped_level();
  level.objects[0].is_ground = true;
  const Level ground = with_object_tiles(level), flat = with_object_tiles(without_groups(level));
  EXPECT_EQ(ground.tile_shapes, flat.tile_shapes);
  EXPECT_EQ(ground.layers.list.back(), flat.layers.list.back());
  level.layers.groups.clear();
  EXPECT_NE(with_object_tiles(level).layers.list.back(), flat.layers.list.back());
}

TEST(LayerGroups, AreMadeAroundALayerOrAGroup) {
  const Level level = grouped_level();
  EXPECT_EQ(after(level, add_group(level, node_of_layer(level, 0))),
            "Group 3(sky) outer(hills inner(trees birds)) front");
  EXPECT_EQ(after(level, add_group(level, *node_of_group(level, 1))),
            "sky outer(hills Group 3(inner(trees birds))) front");
}

TEST(LayerGroups, AreNotMadeDeeperThanFilesMayHaveThem) {
  Level level = grouped_level();
  level.layers.groups.clear();
  for (int i = 0; i < kMaxGroupDepth; ++i) level.layers.groups.push_back({.name = "g", .group = i - 1});
  for (std::size_t i = 1; i < 3; ++i) level.layers.list[i].group = kMaxGroupDepth - 1;
  level.objects[0].group = kMaxGroupDepth - 1;
  const std::vector<LayerNode> nodes = layer_tree(level, false);
  EXPECT_TRUE(add_group(level, *node_of_group(level, 0)).empty());
  EXPECT_FALSE(add_group(level, nodes.front()).empty()) << "beside the others there is room";
  EXPECT_TRUE(write_native(level, {}));
}

TEST(LayerGroups, UngroupedLayersLookAsBefore) {
  for (const int group : {0, 1}) {
    Level level = grouped_level();
    const Level flat = without_groups(level);
    apply_edit(level, ungroup(level, group));
    EXPECT_EQ(text_of(level),
              group == 0 ? "sky hills inner(trees birds) front" : "sky outer(hills trees birds) front");
    EXPECT_EQ(without_groups(level), flat);
  }
  EXPECT_TRUE(ungroup(grouped_level(), 2).empty());
}

TEST(LayerGroups, AreCopiedAndRemovedWithAllThatIsInThem) {
  const Level level = grouped_level();
  EXPECT_EQ(after(level, duplicate_group(level, 0)),
            "sky outer(hills inner(trees birds)) outer copy(hills inner(trees birds)) front");
  EXPECT_EQ(after(level, duplicate_group(level, 1)),
            "sky outer(hills inner(trees birds) inner copy(trees birds)) front");
  EXPECT_EQ(after(level, remove_group(level, 0)), "sky front");
  EXPECT_EQ(after(level, remove_group(level, 1)), "sky outer(hills) front");
  EXPECT_TRUE(has_content(level, 0));
  Level all = level;
  for (TileLayer& layer : all.layers.list) layer.group = 0;
  EXPECT_TRUE(remove_group(all, 0).empty()) << "no layer of tiles would be left";
}

TEST(LayerGroups, ACopyOfTheChosenLayerHasItsCells) {
  Level level = grouped_level();
  level.choose_layer(2);
  apply_edit(level, duplicate_group(level, 1));
  ASSERT_EQ(level.layers.count(), 5);
  EXPECT_EQ(level.cells_of(3), level.cells_of(2));
  EXPECT_EQ(level.layers.chosen, 2);
  apply_edit(level, remove_group(level, 0));
  EXPECT_EQ(text_of(level), "sky front");
  EXPECT_EQ(level.layers.chosen, 0) << "the one behind the group";
  EXPECT_EQ(level.map.at({0, 0}).tile, 1);
}

TEST(LayerGroups, ALayerIsMovedIntoThemAndOut) {
  const Level level = grouped_level();
  EXPECT_EQ(after(level, move_node(level, node_of_layer(level, 3), 2, 0)),
            "sky outer(hills front inner(trees birds))");
  EXPECT_EQ(after(level, move_node(level, node_of_layer(level, 2), 0, -1)),
            "trees sky outer(hills inner(birds)) front");
  EXPECT_EQ(after(level, move_node(level, *node_of_group(level, 1), 5, -1)),
            "sky outer(hills) front inner(trees birds)");
  EXPECT_EQ(after(level, move_node(level, node_of_layer(level, 1), 5, -1)),
            "sky outer(inner(trees birds)) front hills");
  EXPECT_TRUE(move_node(level, *node_of_group(level, 0), 5, 1).empty()) << "into itself";
}

TEST(LayerGroups, StepsGoThroughThem) {
  Level level = grouped_level();
  const auto step = [&](bool forwards) {
    int sky = 0;
    while (level.layers.list[static_cast<std::size_t>(sky)].name != "sky") ++sky;
    apply_edit(level, step_node(level, node_of_layer(level, sky), forwards));
    return text_of(level);
  };
  EXPECT_EQ(step(true), "outer(sky hills inner(trees birds)) front");
  EXPECT_EQ(step(true), "outer(hills sky inner(trees birds)) front");
  EXPECT_EQ(step(true), "outer(hills inner(sky trees birds)) front");
  EXPECT_EQ(step(true), "outer(hills inner(trees sky birds)) front");
  EXPECT_EQ(step(true), "outer(hills inner(trees birds sky)) front");
  EXPECT_EQ(step(true), "outer(hills inner(trees birds) sky) front");
  EXPECT_EQ(step(true), "outer(hills inner(trees birds)) sky front");
  EXPECT_EQ(step(true), "outer(hills inner(trees birds)) front sky");
  EXPECT_EQ(step(true), "outer(hills inner(trees birds)) front sky");
  for (int i = 0; i < 8; ++i) step(false);
  EXPECT_EQ(text_of(level), text_of(grouped_level()));
  EXPECT_EQ(level.layers.groups, grouped_level().layers.groups);
}

TEST(LayerGroups, NewAndCopiedLayersAreInTheGroupOfTheChosenOne) {
  Level level = grouped_level();
  level.choose_layer(1);
  EXPECT_EQ(after(level, add_layer(level)), "sky outer(hills Layer 5 inner(trees birds)) front");
  EXPECT_EQ(after(level, duplicate_layer(level, 1)), "sky outer(hills hills copy inner(trees birds)) front");
  EXPECT_EQ(after(level, remove_layer(level, 1)), "sky outer(inner(trees birds)) front");
}

TEST(LayerGroups, ALockedOneKeepsItsLayers) {
  Level level = grouped_level();
  level.choose_layer(1);
  apply_edit(level, set_group_looks(level, 0, {.name = "outer", .locked = true}));
  const Edit paint{"Paint tiles", {CellChange{{0, 0}, MapCell(), MapCell(1)}}};
  EXPECT_EQ(problem_of_painting(level, paint),
            "The layer \"hills\" is locked: unlock its group under Layers to paint on it.");
  EXPECT_EQ(set_group_looks(level, 0, {.name = "far", .locked = true}).label, "Rename group");
  EXPECT_TRUE(set_group_looks(level, 7, {}).empty());
}

TEST(LayerGroups, AreKeptByNativeLevels) {
  const Level level = grouped_level();
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, HasSubstr("\"talus\": 7"));
  EXPECT_EQ(text_of(level_of_native(text)), text_of(level));
  EXPECT_EQ(level_of_native(text), level);
  EXPECT_EQ(native_of_level(level_of_native(text)), text);
  EXPECT_THAT(native_of_level(without_groups(level)), Not(HasSubstr("group")));
}

TEST(LayerGroups, WrongOnesInNativeLevelsAreErrors) {
  const auto error_of = [](const std::string& members) {
    const auto read = read_level("{\"talus\": 7, " + members + "}", {"json"});
    return read ? "" : read.error().place + ": " + read.error().message;
  };
  EXPECT_EQ(error_of(R"("groups": [{"group": 0}])"),
            "key groups[0].group: must be the number of a group before it");
  EXPECT_EQ(error_of(R"("layers": [{"group": 0}])"),
            "key layers[0].group: must be the number of one of \"groups\"");
  EXPECT_EQ(error_of(R"("groups": [{}], "objects": [{"group": 1}])"),
            "key objects[0].group: must be the number of one of \"groups\"");
  EXPECT_EQ(error_of(R"("groups": [{"opacity": 2}])"), "key groups[0].opacity: must be a number from 0 to 1");
  EXPECT_EQ(error_of(R"("groups": {})"), "key groups: must be a list of up to 4096 groups");
  std::string deep = "{}";
  for (int i = 0; i < kMaxGroupDepth; ++i) deep += ", {\"group\": " + std::to_string(i) + "}";
  EXPECT_EQ(error_of("\"groups\": [" + deep + "]"), "key groups[32]: is in more than 31 other groups");
}

TEST(LayerGroups, AreMergedFieldByField) {
  const Level base = grouped_level();
  Level mine = base, theirs = base;
  mine.layers.groups[0].name = "mine";
  apply_edit(mine, add_group(mine, node_of_layer(mine, 0)));
  theirs.layers.groups[0].visible = false;
  theirs.layers.groups[1].opacity = 1;
  apply_edit(theirs, move_node(theirs, node_of_layer(theirs, 3), 2, 0));
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::mine);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(text_of(merged.level), "Group 3(sky) mine(hills front inner(trees birds))");
  EXPECT_FALSE(merged.level.layers.groups[1].visible);
  EXPECT_EQ(merged.level.layers.groups[2].opacity, 1);
}

TEST(LayerGroups, OfOneNumberAreAskedAboutIfBothChangedThem) {
  const Level base = grouped_level();
  Level mine = base, theirs = base;
  mine.layers.groups[0].opacity = 0.5;
  theirs.layers.groups[0].opacity = 0.25;
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_THAT(merged.conflicts, testing::ElementsAre("1 field of a group of layers"));
  EXPECT_EQ(merged.level.layers.groups[0].opacity, 0.25);
}

}  // namespace talus::layer_groups_test
