// Levels mirrored and moved as a whole.

#include "level/transform.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <talus/sim/scene.h>
#include "level_picture.h"

namespace talus::transform_test {

// The boxes of a level, reflected about the middle of a map of this width.
std::vector<Rect> boxes_of(const Level& level, bool reflected) {
  std::vector<Rect> boxes;
  for (const SceneItem& item : compile_scene(level).items) {
    Rect box = item.box;
    if (reflected) box.x = level.map.width() * kCartTileSize - box.right();
    boxes.push_back(box);
  }
  std::sort(boxes.begin(), boxes.end(),
            [](const Rect& a, const Rect& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return boxes;
}

Level scene() {
  Level level = level_of({".o...#",  //
                          "/-....",  //
                          "###.\\-"});
  Spawn& spawn = level.spawns.emplace_back();
  spawn.position = {3, 2};
  spawn.velocity = {1, -2};
  spawn.size = {4, 6};
  level.tuning.shared.drift_speed = 0.5;
  return level;
}

TEST(Transform, AMirroredLevelHasTheMirroredBoxes) {
  const Level level = scene(), image = mirrored(level);
  EXPECT_EQ(boxes_of(image, false), boxes_of(level, true));
  EXPECT_EQ(image.spawns[0].position, (Vec2{41, 2}));
  EXPECT_EQ(image.spawns[0].velocity, (Vec2{-1, -2}));
  EXPECT_EQ(image.tuning.shared.drift_speed, -0.5);
  EXPECT_EQ(boxes_of(mirrored(image), false), boxes_of(level, false));
}

TEST(Transform, AMirroredUpSlopeIsADownSlope) {
  const Scene image = compile_scene(mirrored(level_of({"/-.."})));
  ASSERT_EQ(image.items.size(), 1u);
  EXPECT_EQ(image.items[0].role, TileRole::down_slope);
  EXPECT_EQ(image.items[0].box, (Rect{16, 0, 16, 8}));
}

TEST(Transform, CurvesAreMirroredAndMoved) {
  Level level = level_of({"........", "........"});
  const std::vector<decltype(Curve::form)> forms = {
      Segment{{8, 4}, {24, 12}},      Arc{{20, 16}, 10, 14, 26, true}, Parabola{{8, 8}, {24, 4}, 2},
      Cubic{{8, 8}, {24, 4}, 0.5, 1}, Sine{8, 40, 8, 2, 16, 4},        Polyline{8, 24, {1, 5, 3}}};
  for (const auto& form : forms) level.curves.emplace_back().curve.form = form;
  const Level image = mirrored(level);
  EXPECT_EQ(image.curves[0].curve.form, decltype(Curve::form)(Segment{{40, 12}, {56, 4}}));
  EXPECT_EQ(image.curves[1].curve.form, decltype(Curve::form)(Arc{{44, 16}, 10, 38, 50, true}));
  EXPECT_EQ(image.curves[3].curve.form, decltype(Curve::form)(Cubic{{40, 4}, {56, 8}, -1, -0.5}));
  EXPECT_EQ(image.curves[4].curve.form, decltype(Curve::form)(Sine{24, 56, 8, -2, 16, 60}));
  EXPECT_EQ(image.curves[5].curve.form, decltype(Curve::form)(Polyline{40, 56, {3, 5, 1}}));
  EXPECT_EQ(mirrored(image), level);

  const Level shifted = moved(level, 2, 1);
  EXPECT_EQ(shifted.map.width(), 10);
  EXPECT_EQ(shifted.curves[2].curve.form, decltype(Curve::form)(Parabola{{24, 16}, {40, 12}, 10}));
  EXPECT_EQ(shifted.curves[5].curve.form, decltype(Curve::form)(Polyline{24, 40, {9, 13, 11}}));
}

TEST(Transform, AnUprightSegmentIsMirroredWithItsFace) {
  Level level = level_of({"...."});
  LevelCurve& wall = level.curves.emplace_back();
  wall.curve.form = Segment{{8, 0}, {8, 8}};
  wall.curve.faces = Curve::Faces::up;
  EXPECT_EQ(mirrored(level).curves[0].curve.faces, Curve::Faces::down);
}

TEST(Transform, MovingMovesEverything) {
  const Level level = scene(), image = moved(level, 3, 2);
  EXPECT_EQ(image.map.tile_at({4, 2}), level.map.tile_at({1, 0}));
  EXPECT_EQ(image.spawns[0].position, (Vec2{27, 18}));
}

}  // namespace talus::transform_test
