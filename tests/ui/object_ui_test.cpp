// Objects on the map: drawn, chosen, moved, resized, named, copied and removed by the object tool.
#include "golden_harness.h"
#include "harness.h"

namespace talus::object_ui_test {

class UiObjects : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    session().apply(action::Pause{});
    key(kKeyF3);
    key('j');
  }
  const std::vector<MapObject>& objects(std::size_t layer = 0) { return level().objects.at(layer).objects; }
  void drag_from(Vec2 from, Vec2 to) { drag(on_canvas("map", from), on_canvas("map", to)); }
};

TEST_F(UiObjects, ARectangleIsDrawnMovedAndResized) {
  drag_from({20, 20}, {52, 44});
  ASSERT_EQ(level().objects.size(), 1U) << "a layer is made for it";
  EXPECT_EQ(objects().at(0).form, MapObject::Form::box);
  EXPECT_EQ(objects()[0].position, (Vec2{20, 20}));
  EXPECT_EQ(objects()[0].size, (Vec2{32, 24}));
  drag_from({30, 30}, {41, 35});
  EXPECT_EQ(objects()[0].position, (Vec2{31, 25}));
  drag(centre("map/object_handle2"), on_canvas("map", {71, 60}));
  EXPECT_EQ(objects()[0].size, (Vec2{40, 35}));
  EXPECT_EQ(session().history().edits().size(), 3U);
  for (int i = 0; i < 3; ++i) key(ctrl('z'));
  EXPECT_TRUE(level().objects.empty());
}

TEST_F(UiObjects, AreMovedByTheArrowsInOneUndo) {
  drag_from({20, 20}, {52, 44});
  const std::size_t before = session().history().edits().size();
  for (int i = 0; i < 3; ++i) key(kKeyRight);
  key(kKeyUp);
  key(shift(kKeyDown));
  EXPECT_EQ(objects().at(0).position, (Vec2{23, 27})) << "three px right, one up, and a cell of 8 px down";
  EXPECT_EQ(session().history().edits().size(), before + 1);
  key(ctrl('z'));
  EXPECT_EQ(objects()[0].position, (Vec2{20, 20}));
  // Another object begins another undo.
  drag_from({100, 20}, {132, 44});
  key(kKeyLeft);
  session().apply(action::SelectObject{{0, 0}});
  key(kKeyLeft);
  EXPECT_EQ(objects()[0].position.x, 19);
  EXPECT_EQ(objects().at(1).position.x, 99);
  key(ctrl('z'));
  EXPECT_EQ(objects()[0].position.x, 20);
  EXPECT_EQ(objects()[1].position.x, 99);
}

TEST_F(UiObjects, ArrowsScrollWithoutAChosenObject) {
  drag_from({20, 20}, {52, 44});
  session().apply(action::SelectObject{{0, -1}});
  frames(1);
  const ImVec2 before = on_canvas("map", {0, 0});
  key(kKeyRight);
  frames(2);
  EXPECT_NE(on_canvas("map", {0, 0}).x, before.x);
  EXPECT_EQ(objects().at(0).position, (Vec2{20, 20}));
}

TEST_F(UiObjects, TheToolHasAButton) {
  key('1');
  click("map/object");
  EXPECT_EQ(session().choices().map_tool, MapTool::object);
}

// With Shift a drag draws, so that the sheet must not lie over the map.
TEST_F(UiObjects, ShiftDrawsAndShowsNoSheet) {
  drag_from({20, 20}, {52, 44});
  hold_modifiers(shift(0));
  move(on_canvas("map", {24, 24}));
  frames(2);
  EXPECT_EQ(find("map/sheet"), nullptr);
  drag_from({24, 24}, {40, 40});
  hold_modifiers();
  EXPECT_EQ(objects().size(), 2U);
}

TEST_F(UiObjects, TheKeyGoesOnToTheNextForm) {
  key('j');
  drag_from({20, 20}, {52, 44});
  EXPECT_EQ(objects().at(0).form, MapObject::Form::ellipse);
  key('j');
  key('j');
  click(on_canvas("map", {80, 20}));
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(objects()[1].position, (Vec2{80, 20}));
  EXPECT_EQ(objects()[1].size, Vec2());
}

TEST_F(UiObjects, APolygonIsClickedCornerByCorner) {
  key('j');
  key('j');
  for (const Vec2 corner : {Vec2{20, 20}, {60, 20}, {60, 50}, {99, 99}}) click(on_canvas("map", corner));
  key(kKeyBackspace);
  EXPECT_TRUE(level().objects.empty()) << "it is not closed yet";
  click(on_canvas("map", {20, 20}));
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(objects()[0].points, (std::vector<Vec2>{{0, 0}, {40, 0}, {40, 30}}));
  drag(centre("map/object_side2"), on_canvas("map", {20, 50}));
  EXPECT_EQ(objects()[0].points, (std::vector<Vec2>{{0, 0}, {40, 0}, {40, 30}, {0, 30}}));
}

TEST_F(UiObjects, EscapeLeavesAPolygon) {
  key('j');
  key('j');
  click(on_canvas("map", {20, 20}));
  click(on_canvas("map", {60, 20}));
  key(kKeyEscape);
  key('j');
  click(on_canvas("map", {80, 60}));
  ASSERT_EQ(objects().size(), 1U) << "only the point";
}

TEST_F(UiObjects, AreNamedCopiedAndRemoved) {
  drag_from({20, 20}, {52, 44});
  click("inspector/object_name");
  type("door");
  key(KeyChord{'\r'});
  click("inspector/object_class");
  type("exit");
  key(KeyChord{'\r'});
  click("inspector/object_one_way");
  EXPECT_EQ(objects().at(0).name, "door");
  EXPECT_EQ(objects()[0].type, "exit");
  EXPECT_TRUE(objects()[0].one_way);
  EXPECT_EQ(objects()[0].properties, "{\"one_way\":true}") << "what files have of it";
  key(kKeyF3);
  key(ctrl('d'));
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(objects()[1].name, "door");
  key(kKeyDelete);
  ASSERT_EQ(objects().size(), 1U) << "the copy was chosen";
  EXPECT_EQ(objects()[0].position, (Vec2{20, 20}));
}

TEST_F(UiObjects, PropertiesAreAddedTypedAndRemoved) {
  drag_from({20, 20}, {52, 44});
  click("inspector/object_new_property");
  type("key");
  click("inspector/object_add_property");
  EXPECT_EQ(objects().at(0).properties, "{\"key\":\"\"}");
  click("inspector/object_property0");
  type("red");
  key(KeyChord{'\r'});
  EXPECT_EQ(objects()[0].properties, "{\"key\":\"red\"}");
  click("inspector/object_property0_remove");
  EXPECT_EQ(objects()[0].properties, "");
}

TEST_F(UiObjects, OfHiddenLayersStayAsTheyAre) {
  drag_from({20, 20}, {52, 44});
  click("tabs/layers");
  click("layers/objects/0/eye");
  ASSERT_FALSE(level().objects.at(0).visible);
  const std::vector<MapObject> before = objects();
  drag_from({30, 30}, {41, 35});
  key(kKeyDelete);
  EXPECT_EQ(objects(), before);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "The layer of objects \"objects\" is hidden: show it under Layers to change it.");
}

}  // namespace talus::object_ui_test
