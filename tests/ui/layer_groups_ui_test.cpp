// Groups of layers in the panel of layers.
#include "edit/group_tools.h"
#include "harness.h"
#include "unit/pictured_level.h"

namespace talus::layer_groups_ui_test {

// test_level() with its tiles in "land", which is chosen, behind the group "far" with "hills" and "trees".
Level grouped_level(Level level) {
  const auto with = [&](Cell cell, TileNumber tile) {
    std::vector<TileNumber> cells(level.map.cells().size());
    cells[static_cast<std::size_t>(cell.y) * level.map.width() + cell.x] = tile;
    return std::make_shared<const MapCells>(std::move(cells));
  };
  level.layers.list = {{.name = "land"},
                       {.name = "hills", .is_ground = false, .group = 0, .cells = with({10, 5}, 1)},
                       {.name = "trees", .is_ground = false, .group = 0, .cells = with({11, 5}, 1)}};
  level.layers.groups = {{.name = "far"}};
  return level;
}

class UiLayerGroups : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    const std::string file = path("level.talus.json");
    ASSERT_TRUE(save_level(grouped_level(test_level()), *find_format("native"), file));
    start(file, 1600, 1000);
    session().apply(action::Pause{});
    click("tabs/layers");
    frames(2);
  }
  const TileLayers& layers() { return level().layers; }
  // "land far[hills trees]": from the back; groups in groups are not told.
  std::string text() {
    std::string text;
    int group = -1;
    for (const TileLayer& layer : layers().list) {
      if (group >= 0 && layer.group != group) text += "]";
      if (!text.empty() && !text.ends_with('[')) text += " ";
      if (layer.group >= 0 && layer.group != group) text += group_name(level(), layer.group) + "[";
      text += layer.name;
      group = layer.group;
    }
    return text + (group >= 0 ? "]" : "");
  }
  ImVec2 row(int index) { return centre("layers/" + std::to_string(index)); }
  ImVec2 group() { return centre("layers/groups/0"); }
  std::string label() { return session().history().edits().back().label; }
};

TEST_F(UiLayerGroups, HaveRowsThatFold) {
  ASSERT_NE(find("layers/groups/0"), nullptr);
  EXPECT_GT(find("layers/1")->min.x, find("layers/0")->min.x) << "what is in a group is indented";
  EXPECT_LT(group().y, row(2).y) << "the group is above its layers";
  click("layers/groups/0/fold");
  frames(2);
  EXPECT_EQ(find("layers/1"), nullptr);
  EXPECT_NE(find("layers/0"), nullptr);
  click("layers/groups/0/fold");
  frames(2);
  EXPECT_NE(find("layers/1"), nullptr);
}

TEST_F(UiLayerGroups, HaveAnEyeAndALock) {
  click("layers/groups/0/eye");
  EXPECT_FALSE(layers().groups[0].visible);
  EXPECT_TRUE(layers().list[1].visible) << "the layers keep their own";
  EXPECT_EQ(label(), "Hide group");
  click("layers/groups/0/lock");
  EXPECT_TRUE(layers().groups[0].locked);
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_EQ(layers().groups[0], LayerGroup{.name = "far"});
}

TEST_F(UiLayerGroups, ADragMovesALayerInAndOut) {
  drag(row(0), {group().x, find("layers/groups/0")->max.y - 1});
  EXPECT_EQ(text(), "far[hills trees land]");
  EXPECT_EQ(label(), "Move layer");
  key(ctrl('z'));
  EXPECT_EQ(text(), "land far[hills trees]");
  drag(row(2), {group().x, find("layers/groups/0")->min.y + 1});
  EXPECT_EQ(text(), "land far[hills] trees");
  key(ctrl('z'));
  click(row(0));  // else the next press would be a double click
  drag(row(2), {find("layers/0/eye")->min.x + 2, find("layers/0")->min.y + 1});
  EXPECT_EQ(text(), "land trees far[hills]") << "left of the indentation it leaves the group";
}

TEST_F(UiLayerGroups, ADragMovesAGroupWithItsLayers) {
  drag(group(), {group().x, find("layers/0")->max.y - 1});
  EXPECT_EQ(text(), "far[hills trees] land");
  EXPECT_EQ(label(), "Move group");
}

TEST_F(UiLayerGroups, ButtonsWorkOnTheChosenOne) {
  click("layers/group_button");
  EXPECT_EQ(text(), "Group 2[land] far[hills trees]");
  key(ctrl('z'));
  click(group());
  click("layers/duplicate_button");
  EXPECT_EQ(text(), "land far[hills trees] far copy[hills trees]");
  key(ctrl('z'));
  click(group());
  click("layers/backwards_button");
  EXPECT_EQ(text(), "far[hills trees] land");
}

TEST_F(UiLayerGroups, DeletingOneAsks) {
  click(group());
  click("layers/delete_button");
  frames(3);
  ASSERT_NE(find("delete_group/delete"), nullptr);
  click("delete_group/cancel");
  EXPECT_EQ(text(), "land far[hills trees]");
  click("layers/delete_button");
  frames(3);
  click("delete_group/ungroup");
  EXPECT_EQ(text(), "land hills trees");
  key(ctrl('z'));
  click(group());
  click("layers/delete_button");
  frames(3);
  click("delete_group/delete");
  EXPECT_EQ(text(), "land");
  EXPECT_EQ(label(), "Delete group");
  key(ctrl('z'));
  EXPECT_EQ(text(), "land far[hills trees]");
}

TEST_F(UiLayerGroups, AreRenamedAndHaveLooks) {
  click(group());
  click(group());
  frames(3);
  ASSERT_NE(find("layers/name"), nullptr);
  type("near");
  key('\r');
  frames(2);
  EXPECT_EQ(layers().groups[0].name, "near");
  click("layers/offset_x");
  click("layers/offset_x");
  key(ctrl('a'));
  type("12");
  key('\r');
  EXPECT_EQ(layers().groups[0].offset.x, 12);
  EXPECT_EQ(label(), "Change a group's offset");
}

}  // namespace talus::layer_groups_ui_test
