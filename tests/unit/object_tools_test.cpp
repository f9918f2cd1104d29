// Objects of the map: where they are grabbed, and what becomes of them.
#include <gtest/gtest.h>

#include "edit/object_handles.h"
#include "level/edit.h"

namespace talus::object_tools_test {

using Form = MapObject::Form;

Level level_with(std::vector<MapObject> objects) {
  Level level;
  level.map = TileMap(10, 10, {16, 16});
  level.objects.push_back({.name = "o", .objects = std::move(objects)});
  return level;
}

MapObject box(Vec2 at, Vec2 size) { return {.position = at, .size = size}; }

const MapObject& first(const Level& level) { return level.objects.at(0).objects.at(0); }

TEST(ObjectTools, TheFrontmostOneIsGrabbed) {
  Level level = level_with({box({0, 0}, {40, 40}), box({10, 10}, {10, 10})});
  EXPECT_EQ(object_at(level, {15, 15}, 2), (ObjectRef{0, 1}));
  EXPECT_EQ(object_at(level, {30, 30}, 2), (ObjectRef{0, 0}));
  EXPECT_EQ(object_at(level, {41, 30}, 2), (ObjectRef{0, 0})) << "its outline is near";
  EXPECT_EQ(object_at(level, {43, 30}, 2), ObjectRef());
  level.objects[0].visible = false;
  EXPECT_EQ(object_at(level, {15, 15}, 2), ObjectRef());
}

TEST(ObjectTools, EveryFormIsGrabbed) {
  MapObject line{.form = Form::polyline, .position = {50, 50}, .points = {{0, 0}, {20, 0}}};
  MapObject picture{.form = Form::tile, .position = {100, 100}, .size = {16, 16}, .tile = 1};
  MapObject area = polygon_through({{70, 0}, {90, 0}, {90, 20}});
  const Level level = level_with({line, picture, area, box({5, 90}, {0, 0})});
  EXPECT_EQ(object_at(level, {60, 51}, 2).index, 0);
  EXPECT_EQ(object_at(level, {60, 54}, 2).index, -1);
  EXPECT_EQ(object_at(level, {108, 90}, 2).index, 1) << "pictures stand on their place";
  EXPECT_EQ(object_at(level, {88, 10}, 0).index, 2);
  EXPECT_EQ(object_at(level, {72, 15}, 0).index, -1);
  EXPECT_EQ(object_at(level, {6, 91}, 2).index, 3) << "a point";
}

TEST(ObjectTools, ACornerResizesABox) {
  const MapObject before = box({10, 10}, {20, 30});
  EXPECT_EQ(with_handle(before, 2, {35, 50}), box({10, 10}, {25, 40}));
  EXPECT_EQ(with_handle(before, 0, {5, 20}), box({5, 20}, {25, 20}));
  EXPECT_EQ(with_handle(before, 1, {5, 0}), box({5, 0}, {5, 40})) << "beyond the opposite corner";
}

TEST(ObjectTools, ACornerOfATurnedBoxKeepsTheOpposite) {
  MapObject object = box({10, 10}, {20, 30});
  object.rotation = 30;
  const std::vector<Vec2> before = handles_of(object);
  for (int handle = 0; handle < 4; ++handle) {
    const Vec2 place = before[static_cast<std::size_t>(handle)] + Vec2{3, 2};
    const std::vector<Vec2> after = handles_of(with_handle(object, handle, place));
    const auto opposite = static_cast<std::size_t>((handle + 2) % 4);
    EXPECT_NEAR(after[opposite].x, before[opposite].x, 0.01) << handle;
    EXPECT_NEAR(after[opposite].y, before[opposite].y, 0.01) << handle;
    EXPECT_NEAR(after[static_cast<std::size_t>(handle)].x, place.x, 0.01) << handle;
    EXPECT_NEAR(after[static_cast<std::size_t>(handle)].y, place.y, 0.01) << handle;
  }
}

TEST(ObjectTools, PointsOfPolygonsComeAndGo) {
  const MapObject area = polygon_through({{10, 10}, {30, 10}, {30, 30}});
  EXPECT_EQ(area.position, (Vec2{10, 10}));
  const std::vector<Vec2> middles = middles_of(area);
  ASSERT_EQ(middles.size(), 3U);
  EXPECT_EQ(middles[2], (Vec2{20, 20}));
  const MapObject larger = with_point_after(area, 2, {10, 30});
  EXPECT_EQ(larger.points, (std::vector<Vec2>{{0, 0}, {20, 0}, {20, 20}, {0, 20}}));
  EXPECT_EQ(without_point(larger, 3), area);
  EXPECT_EQ(without_point(area, 0), area) << "a polygon has at least three";
}

TEST(ObjectTools, EditsAreUndone) {
  Level level = level_with({box({0, 0}, {8, 8})});
  const Level before = level;
  for (const Edit& edit :
       {add_object(level, 0, box({1, 1}, {2, 2})), remove_object(level, {0, 0}),
        duplicate_object(level, {0, 0}), change_object(level, {0, 0}, box({3, 3}, {4, 4}), "x"),
        add_object(level, -1, box({1, 1}, {2, 2}))}) {
    EXPECT_FALSE(edit.empty());
    apply_edit(level, edit);
    EXPECT_NE(level.objects, before.objects);
    revert_edit(level, edit);
    EXPECT_EQ(level.objects, before.objects);
  }
  EXPECT_TRUE(change_object(level, {0, 0}, first(level), "x").empty());
  EXPECT_TRUE(remove_object(level, {0, 7}).empty());
  EXPECT_TRUE(duplicate_object(level, {5, 0}).empty());
}

TEST(ObjectTools, ANewLayerIsMadeIfThereIsNone) {
  Level level;
  EXPECT_EQ(place_of_added(level, -1), (ObjectRef{0, 0}));
  apply_edit(level, add_object(level, -1, box({1, 1}, {2, 2})));
  ASSERT_EQ(level.objects.size(), 1U);
  EXPECT_EQ(level.objects[0].name, "objects");
  EXPECT_EQ(place_of_added(level, 0), (ObjectRef{0, 1}));
}

TEST(ObjectTools, TitlesAreNamesClassesOrForms) {
  MapObject named = box({0, 0}, {1, 1}), classed = named;
  named.name = "n";
  classed.type = "c";
  const Level level = level_with({named, classed, box({0, 0}, {0, 0})});
  EXPECT_EQ(object_title(level, {0, 0}), "n");
  EXPECT_EQ(object_title(level, {0, 1}), "c");
  EXPECT_EQ(object_title(level, {0, 2}), "point 3");
  EXPECT_EQ(object_title(level, {}), "no object");
}

}  // namespace talus::object_tools_test
