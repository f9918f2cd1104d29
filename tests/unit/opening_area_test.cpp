// What of a level is shown first, and at which zoom.
#include "panels/canvas/opening_area.h"

#include <gtest/gtest.h>

#include "panels/canvas/camera.h"

namespace talus::opening_area_test {

const ImVec2 kCanvas{600, 400};

Level level_of(int width, int height) {
  Level level;
  level.map = TileMap(width, height);
  return level;
}

Body body_at(double x, double y, BodyKind kind = BodyKind::ball) {
  Body body;
  body.box = {x, y, 8, 8};
  body.kind = kind;
  return body;
}

State state_of(std::vector<Body> bodies) {
  State state;
  for (Body& body : bodies) body.id = state.next_id++;
  state.bodies = std::move(bodies);
  return state;
}

bool holds(const Rect& area, const Rect& part) {
  return area.x <= part.x && area.y <= part.y && part.right() <= area.right() &&
         part.bottom() <= area.bottom();
}

TEST(OpeningArea, IsAScreenAroundThePlayer) {
  const Level level = level_of(200, 100);
  const Body player = body_at(1000, 400, BodyKind::player);
  const OpeningArea shown = opening_area(level, state_of({body_at(8, 8), player}));
  EXPECT_EQ(shown.area, (Rect{1004 - 120, 404 - 68 - 17, 240, 136}));
  EXPECT_TRUE(shown.may_be_cut);
}

TEST(OpeningArea, AScreenGoesWithTheBodies) {
  const Level tall = level_of(30, 200);
  const State low = state_of({body_at(8, 1200), body_at(16, 1208)});
  EXPECT_TRUE(holds(screen_with_bodies(tall, low, 0), {8, 1200, 16, 16}));
  EXPECT_EQ(screen_with_bodies(tall, state_of({body_at(8, 8)}), 0), (Rect{0, 0, 240, 136}))
      << "the first one";
  const State apart = state_of({body_at(8, 8), body_at(100, 1500)});
  EXPECT_EQ(screen_with_bodies(tall, apart, 0), (Rect{0, 0, 240, 136}));
  EXPECT_TRUE(holds(screen_with_bodies(tall, apart, 2), {100, 1500, 8, 8}));
  EXPECT_EQ(screen_with_bodies(tall, state_of({body_at(8, 5000)}), 1), (Rect{0, 1600 - 136, 240, 136}));
}

TEST(OpeningArea, StaysOnTheMap) {
  const OpeningArea shown =
      opening_area(level_of(200, 100), state_of({body_at(-500, 5000, BodyKind::player)}));
  EXPECT_EQ(shown.area, (Rect{0, 800 - 136, 240, 136}));
  EXPECT_EQ(opening_area(level_of(4, 3), state_of({body_at(8, 8, BodyKind::player)})).area,
            (Rect{0, 0, 32, 24}));
}

TEST(OpeningArea, HoldsAllBodiesIfThereIsNoPlayer) {
  const State near = state_of({body_at(1000, 400), body_at(1300, 500)});
  EXPECT_TRUE(holds(opening_area(level_of(200, 100), near).area, {1000, 400, 308, 108}));
  EXPECT_FALSE(opening_area(level_of(200, 100), near).may_be_cut);
  const State far = state_of({body_at(1500, 700), body_at(8, 8)});
  EXPECT_TRUE(holds(opening_area(level_of(200, 100), far).area, far.bodies.front().box)) << "else the first";
}

TEST(OpeningArea, IsTheGroundIfThereIsNoBody) {
  Level large = level_of(200, 100);
  EXPECT_EQ(opening_area(large, State()).area, (Rect{0, 0, 240, 136}))
      << "of an empty level the first screen";
  large.map.set({70, 40}, 1);
  EXPECT_EQ(opening_area(large, State()).area, (Rect{480, 272, 240, 136}));
  Level small = level_of(50, 30);
  small.map.set({49, 29}, 1);
  small.map.set({40, 20}, 1);
  const Rect shown = opening_area(small, State()).area;
  EXPECT_TRUE(holds(shown, {320, 160, 80, 80}));
  EXPECT_EQ(shown.right(), 400);
  EXPECT_EQ(shown.bottom(), 240);
}

TEST(OpeningArea, TilesThatAreOnlyDrawnDoNotCount) {
  Level level = level_of(200, 100);
  level.map.set({70, 40}, 1);
  level.layers.list.front().is_ground = false;
  EXPECT_EQ(opening_area(level, State()).area, (Rect{0, 0, 240, 136}));
}

TEST(OpeningArea, NothingIsShownBesideWhatALevelUses) {
  Level level = level_of(240, 136);
  const State balls = state_of({body_at(16, 20)});
  level.map.set({2, 1}, 1);
  level.map.set({29, 16}, 1);
  EXPECT_EQ(opening_area(level, balls).bounds, (Rect{16, 8, 224, 128}));
  EXPECT_EQ(opening_area(level, State()).bounds, (Rect{16, 8, 224, 128}));
  const Rect whole{0, 0, 1920, 1088};
  EXPECT_EQ(opening_area(level, state_of({body_at(16, 20, BodyKind::player)})).bounds, whole)
      << "the view goes with the player";
  level.objects.emplace_back();
  EXPECT_EQ(opening_area(level, balls).bounds, whole) << "pictures may lie there";
}

TEST(OpeningArea, IsAllThatALevelUsesIfThatIsHardlyMore) {
  Level level = level_of(240, 136);
  level.map.set({0, 0}, 1);
  level.map.set({29, 16}, 1);
  EXPECT_EQ(opening_area(level, state_of({body_at(16, 20), body_at(216, 100)})).area, (Rect{0, 0, 240, 136}));
  level.map.set({59, 16}, 1);
  EXPECT_LT(opening_area(level, state_of({body_at(16, 20), body_at(216, 100)})).area.w, 300);
}

TEST(FollowedBody, IsTheChosenOneElseThePlayer) {
  const State state = state_of({body_at(0, 0), body_at(8, 8, BodyKind::player), body_at(16, 0)});
  EXPECT_EQ(followed_body(state, 0)->id, 2);
  EXPECT_EQ(followed_body(state, 3)->id, 3);
  EXPECT_EQ(followed_body(state_of({body_at(0, 0)}), 0), nullptr);
}

float zoom_for(Rect area, bool may_be_cut) {
  Camera camera;
  camera.show(area, may_be_cut, {0, 0, 10'000, 10'000}, kCanvas);
  return camera.zoom();
}

TEST(CameraShow, TakesAWholeZoomThatIsClose) {
  EXPECT_EQ(zoom_for({0, 0, 200, 100}, false), 3.0f);
  EXPECT_EQ(zoom_for({0, 0, 170, 100}, false), 3.0f) << "of 3.5, a seventh is less than one sees";
  EXPECT_FLOAT_EQ(zoom_for({0, 0, 320, 100}, false), 1.875f) << "1x would be half as large";
  EXPECT_EQ(zoom_for({0, 0, 320, 100}, true), 2.0f) << "a screen may lose its edges";
  EXPECT_FLOAT_EQ(zoom_for({0, 0, 1304, 400}, false), 600.0f / 1304) << "0.46x, and not 1/4x";
}

TEST(CameraShow, ShowsNothingBesideTheMap) {
  Camera camera;
  camera.show({0, 0, 200, 100}, false, {0, 0, 1000, 100}, kCanvas);
  const CanvasView view = camera.view({0, 0}, kCanvas, {});
  EXPECT_EQ(view.visible().x, 0) << "the map goes on to the right";
  EXPECT_NEAR(view.visible().center().y, 50, 0.5) << "a low map lies in the middle";
}

TEST(CameraShow, APartThatIsLowLiesInTheMiddle) {
  Camera camera;
  camera.show({100, 40, 200, 100}, false, {100, 40, 300, 60}, kCanvas);
  const Rect seen = camera.view({0, 0}, kCanvas, {}).visible();
  EXPECT_EQ(seen.x, 100) << "the part goes on to the right";
  EXPECT_NEAR(seen.center().y, 70, 0.5);
}

TEST(CameraShow, ZoomingFromBetweenTwoStepsGoesToThem) {
  Camera camera;
  const auto at_1_875 = [&] { camera.show({0, 0, 320, 100}, false, {0, 0, 10'000, 10'000}, kCanvas); };
  at_1_875();
  EXPECT_TRUE(camera.is_untouched());
  camera.zoom_at({0, 0}, 1);
  EXPECT_EQ(camera.zoom(), 2.0f);
  EXPECT_FALSE(camera.is_untouched());
  at_1_875();
  camera.zoom_at({0, 0}, -1);
  EXPECT_EQ(camera.zoom(), 1.0f);
}

TEST(CameraShow, TheWorldViewGoesBackToAZoomBetweenSteps) {
  Camera camera;
  camera.show({0, 0, 320, 100}, false, {0, 0, 10'000, 10'000}, kCanvas);
  camera.toggle_whole({10'000, 10'000}, kCanvas);
  EXPECT_LT(camera.zoom(), 1);
  camera.toggle_whole({10'000, 10'000}, kCanvas);
  EXPECT_FLOAT_EQ(camera.zoom(), 1.875f);
}

}  // namespace talus::opening_area_test
