// Overlays: their table, and the exact geometry that they draw for handmade records.
#include "overlay/overlay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "collision/ground_queries.h"
#include "overlay/motion.h"
#include "overlay/number_label.h"
#include "overlay/stage_drawing.h"

namespace talus::overlay_test {

constexpr Rect kEverything{-1000, -1000, 4000, 4000};

OverlaySet only(const Overlay& overlay) {
  OverlaySet set;
  set.set(overlay, true);
  return set;
}

Body body(int id, Rect box, Vec2 velocity = {}) {
  Body made;
  made.id = id;
  made.box = box;
  made.velocity = velocity;
  made.previous = box.position();
  return made;
}

SceneItem item(TileRole role, Rect box) {
  SceneItem made;
  made.role = role;
  made.box = box;
  return made;
}

State state_of(std::vector<Body> bodies) {
  State state;
  state.frame = 1;
  state.bodies = std::move(bodies);
  return state;
}

ContactRecord contact(Rect other, Vec2 normal, Vec2 touch) {
  ContactRecord record;
  record.body = 1;
  record.other.box = other;
  record.normal = normal;
  record.touch = touch;
  record.ti = 0.25;
  return record;
}

// Body 1 on an up-slope of 16x8 at (16, 88), its centre 7/16 along.
StepRecord on_slope() {
  ContactRecord record = contact({16, 88, 16, 8}, {0, -1}, {19, 80});
  record.other.role = TileRole::up_slope;
  record.slope = SlopeProbe{record.other, 0.4375, 92.4375, 84, {-0.6, -0.8}, true};
  StepRecord step;
  step.contacts = {record};
  return step;
}
const Rect kBall{19, 84, 8, 8};

OverlayDrawing drawn(const Scene& scene, const State& state, const StepRecord& record, OverlaySet overlays,
                     int chosen_body = 0, Rect visible = kEverything) {
  return make_overlays({.scene = scene,
                        .state = state,
                        .record = record,
                        .ground = scene.ground.get(),
                        .chosen_body = chosen_body},
                       overlays, visible);
}

// Relative luminance by WCAG 2.
double luminance(std::uint32_t rgb) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear((rgb >> 16 & 255) / 255.0) + 0.7152 * linear((rgb >> 8 & 255) / 255.0) +
         0.0722 * linear((rgb & 255) / 255.0);
}

TEST(Overlays, HaveColoursAndKeysOfTheirOwn) {
  std::set<std::uint32_t> colors;
  std::set<std::pair<bool, char>> keys;
  for (const Overlay* overlay : all_overlays()) {
    EXPECT_EQ(find_overlay(overlay->key), overlay);
    EXPECT_NE(overlay->draw_swatch, nullptr) << overlay->key;
    colors.insert(overlay->color);
    keys.insert({overlay->shift, overlay->digit});
  }
  EXPECT_EQ(colors.size(), all_overlays().size()) << "one colour each";
  EXPECT_EQ(keys.size(), all_overlays().size()) << "one key each";
  EXPECT_EQ(find_overlay("floor"), nullptr);
}

TEST(Overlays, AreLegibleOnTheDarkBackground) {
  for (const Overlay* overlay : all_overlays()) {
    const double contrast = (luminance(overlay->color) + 0.05) / (luminance(0x1a1c2c) + 0.05);
    EXPECT_GT(contrast, 4) << overlay->key;
  }
}

TEST(OverlaySet, HoldsWhatWasSet) {
  OverlaySet set;
  EXPECT_TRUE(set.empty());
  set.set(overlay::velocity, true);
  EXPECT_TRUE(set.has(overlay::velocity));
  EXPECT_FALSE(set.has(overlay::boxes));
  for (const Overlay* overlay : all_overlays()) EXPECT_TRUE(OverlaySet::all().has(*overlay));
}

TEST(Overlays, NothingIsDrawnWhenNoneIsOn) {
  const OverlayDrawing drawing = drawn({}, state_of({body(1, kBall, {1, 1})}), on_slope(), {}, 1);
  EXPECT_TRUE(drawing.lines.empty() && drawing.boxes.empty() && drawing.marks.empty() &&
              drawing.bars.empty() && drawing.labels.empty());
}

TEST(Overlays, DrawsBoxesOfTilesAndBodiesButNotOfSpawns) {
  Scene scene;
  scene.items = {item(TileRole::solid, {0, 96, 8, 8}), item(TileRole::up_slope, {16, 88, 16, 8}),
                 item(TileRole::ball, {40, 0, 8, 8})};
  const auto drawing = drawn(scene, state_of({body(1, kBall)}), {}, only(overlay::boxes), 0);
  ASSERT_EQ(drawing.boxes.size(), 3u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{0, 96, 8, 8}));
  EXPECT_EQ(drawing.boxes[1].box, (Rect{16, 88, 16, 8}));
  EXPECT_EQ(drawing.boxes[2].box, kBall);
  EXPECT_FALSE(drawing.boxes[2].filled);
}

TEST(Overlays, LeavesOutWhatIsOutOfSight) {
  Scene scene;
  scene.items = {item(TileRole::solid, {0, 0, 8, 8}), item(TileRole::solid, {80, 0, 8, 8})};
  const auto drawing = drawn(scene, {}, {}, only(overlay::boxes), 0, {4, 4, 40, 40});
  ASSERT_EQ(drawing.boxes.size(), 1u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{0, 0, 8, 8}));
}

//      +--+ ball at (4, 0), 8 wide
//      |  |
//    +-++-+--+  the floor's top from x 0 to 8: they share x 4 to 8
TEST(Overlays, NormalStartsInTheMiddleOfTheSharedSide) {
  StepRecord record;
  record.contacts = {contact({0, 8, 8, 8}, {0, -1}, {4, 0})};
  const auto drawing = drawn({}, state_of({body(1, {4, 0, 8, 8})}), record, only(overlay::normals), 0);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].from, (Vec2{6, 8}));
  EXPECT_EQ(drawing.lines[0].to, (Vec2{6, 0}));
  EXPECT_TRUE(drawing.lines[0].arrow);
}

TEST(Overlays, NormalOfEachSide) {
  const struct {
    Vec2 normal, touch, from, to;
  } cases[] = {
      {{1, 0}, {8, 2}, {8, 5}, {16, 5}},    // from the right
      {{-1, 0}, {-8, 2}, {0, 5}, {-8, 5}},  // from the left
      {{0, 1}, {2, 8}, {5, 8}, {5, 16}},    // from below
      {{0, -1}, {2, -8}, {5, 0}, {5, -8}},  // from above
  };
  for (const auto& c : cases) {
    StepRecord record;
    record.contacts = {contact({0, 0, 8, 8}, c.normal, c.touch)};
    const auto drawing = drawn({}, state_of({body(1, {0, 0, 8, 8})}), record, only(overlay::normals), 0);
    ASSERT_EQ(drawing.lines.size(), 1u);
    EXPECT_EQ(drawing.lines[0].from, c.from);
    EXPECT_EQ(drawing.lines[0].to, c.to);
  }
}

TEST(Overlays, AContactWithoutADirectionHasNoArrow) {
  StepRecord record;
  record.contacts = {contact({0, 0, 8, 8}, {0, 0}, {2, 2})};
  const State state = state_of({body(1, {2, 2, 8, 8})});
  EXPECT_TRUE(drawn({}, state, record, only(overlay::normals), 0).lines.empty());
  const auto drawing = drawn({}, state, record, only(overlay::touch_points), 0);
  ASSERT_EQ(drawing.marks.size(), 1u);
  EXPECT_EQ(drawing.marks[0].at, (Vec2{5, 5})) << "the middle of the overlap";
}

TEST(Overlays, AnImpulseIsDrawnAsTheSpeedThatItGave) {
  StepRecord record;
  record.contacts = {contact({0, 8, 16, 8}, {0, -1}, {4, -8})};
  const State state = state_of({body(1, {4, -8, 8, 16})});  // twice as heavy as a ball
  EXPECT_TRUE(drawn({}, state, record, only(overlay::impulses), 0).lines.empty()) << "it only rests";
  record.contacts[0].impulse = 6;
  const auto drawing = drawn({}, state, record, only(overlay::impulses), 0);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].from, (Vec2{8, 8}));
  EXPECT_EQ(drawing.lines[0].to, (Vec2{8, 8 - 3 * 4}));
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "6.00");
  record.contacts[0].impulse = 0.004;
  EXPECT_TRUE(drawn({}, state, record, only(overlay::impulses), 0).labels.empty()) << "it would be 0.00";
}

TEST(Overlays, TouchPointHasTheTimeOfImpact) {
  StepRecord record;
  record.contacts = {contact({0, 8, 8, 8}, {0, -1}, {4, 0})};
  const auto drawing = drawn({}, state_of({body(1, {4, 0, 8, 8})}), record, only(overlay::touch_points), 0);
  ASSERT_EQ(drawing.marks.size(), 1u);
  EXPECT_EQ(drawing.marks[0].at, (Vec2{6, 8}));
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "t 0.25");
  EXPECT_EQ(drawing.labels[0].at, (Vec2{6, 8}));
  EXPECT_FALSE(drawing.labels[0].important);
  record.contacts[0].overlaps = true;
  record.contacts[0].ti = -16;  // no time, but minus the overlapping area
  const auto inside = drawn({}, state_of({body(1, {4, 0, 8, 8})}), record, only(overlay::touch_points), 0);
  ASSERT_EQ(inside.labels.size(), 1u);
  EXPECT_EQ(inside.labels[0].text, "inside");
}

TEST(Overlays, VelocityIsDrawnFourTimesAsLong) {
  const State state = state_of({body(1, {0, 0, 8, 8}, {1.5, -0.25}), body(2, {20, 0, 8, 8})});
  const auto drawing = drawn({}, state, {}, only(overlay::velocity), 1);
  ASSERT_EQ(drawing.lines.size(), 1u) << "a body at rest has no arrow";
  EXPECT_EQ(drawing.lines[0].from, (Vec2{4, 4}));
  EXPECT_EQ(drawing.lines[0].to, (Vec2{10, 3}));
  EXPECT_TRUE(drawing.lines[0].arrow);
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "1.50, -0.25");
}

TEST(Overlays, OnlyTheChosenBodysLabelsAreImportant) {
  const State state = state_of({body(1, {0, 0, 8, 8}, {1, 0}), body(2, {20, 0, 8, 8}, {1, 0})});
  const auto drawing = drawn({}, state, {}, only(overlay::velocity), 2);
  ASSERT_EQ(drawing.labels.size(), 2u);
  EXPECT_FALSE(drawing.labels[0].important);
  EXPECT_TRUE(drawing.labels[1].important);
}

TEST(Overlays, SlopeDeltaIsABarAndANumber) {
  const auto drawing = drawn({}, state_of({body(1, kBall)}), on_slope(), only(overlay::slope_delta), 1);
  ASSERT_EQ(drawing.bars.size(), 1u);
  EXPECT_EQ(drawing.bars[0].box, (Rect{19, 80, 8, 2}));
  EXPECT_EQ(drawing.bars[0].fraction, 0.4375);
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "delta 0.44");
  EXPECT_EQ(drawing.labels[0].at, (Vec2{23, 80}));
  EXPECT_TRUE(drawing.labels[0].important);
}

TEST(Overlays, FloorHeightIsALineOnTheSlopesSurface) {
  const auto drawing = drawn({}, state_of({body(1, kBall)}), on_slope(), only(overlay::floor_height), 1);
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_EQ(drawing.lines[0].from, (Vec2{16, 96})) << "an up-slope is low on the left";
  EXPECT_EQ(drawing.lines[0].to, (Vec2{32, 88}));
  EXPECT_EQ(drawing.lines[1].from, (Vec2{15, 92.4375}));
  EXPECT_EQ(drawing.lines[1].to, (Vec2{31, 92.4375}));
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "floor 92.44 -> 92");
  EXPECT_EQ(drawing.labels[0].at, (Vec2{31, 92.4375}));
}

TEST(Overlays, ADownSlopesSurfaceIsHighOnTheLeft) {
  StepRecord record = on_slope();
  record.contacts[0].slope->slope.role = TileRole::down_slope;
  const auto drawing = drawn({}, state_of({body(1, kBall)}), record, only(overlay::floor_height), 1);
  EXPECT_EQ(drawing.lines.at(0).from, (Vec2{16, 88}));
  EXPECT_EQ(drawing.lines.at(0).to, (Vec2{32, 96}));
}

TEST(Overlays, ASlopesOwnNormalStandsOnItsFloor) {
  const auto drawing = drawn({}, state_of({body(1, kBall)}), on_slope(), only(overlay::normals), 1);
  ASSERT_EQ(drawing.lines.size(), 2u) << "the box's and the slope's";
  EXPECT_EQ(drawing.lines[1].from, (Vec2{23, 92.4375}));
  EXPECT_DOUBLE_EQ(drawing.lines[1].to.x, 23 - 4.8);
  EXPECT_DOUBLE_EQ(drawing.lines[1].to.y, 92.4375 - 6.4);
}

TEST(Overlays, TheLastSearchForAFloorCounts) {
  StepRecord record = on_slope();
  record.contacts.push_back(record.contacts[0]);
  record.contacts[1].slope->delta = 0.75;
  const auto drawing = drawn({}, state_of({body(1, kBall)}), record, only(overlay::slope_delta), 1);
  ASSERT_EQ(drawing.bars.size(), 1u);
  EXPECT_EQ(drawing.bars[0].fraction, 0.75);
}

TEST(Overlays, TestedTilesAreTintedOnce) {
  const Obstacle floor{TileRole::solid, {1, 12}, 0, {8, 96, 8, 8}};
  const Obstacle other{TileRole::ball, {}, 2, {20, 80, 8, 8}};
  StepRecord record;
  record.tested = {{1, floor}, {1, other}, {2, floor}};
  const auto drawing = drawn({}, {}, record, only(overlay::tested_tiles), 0);
  ASSERT_EQ(drawing.boxes.size(), 2u);
  EXPECT_EQ(drawing.boxes[0].box, floor.box);
  EXPECT_EQ(drawing.boxes[1].box, other.box);
  EXPECT_TRUE(drawing.boxes[0].filled && drawing.boxes[1].filled);
}

TEST(Overlays, ARemovedBodyIsNotDrawn) {
  const auto drawing = drawn({}, state_of({}), on_slope(), OverlaySet::all(), 1);
  EXPECT_TRUE(drawing.lines.empty() && drawing.marks.empty() && drawing.bars.empty() &&
              drawing.labels.empty());
}

// A slope of 16x8 px from (16, 96) up to (32, 88), level ground behind it, and two balls in the air.
TEST(Overlays, FloorHeightIsTheGroundBelowEachBody) {
  Level level;
  level.map = TileMap(30, 17);
  level.tile_shapes[1] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 8}};
  level.tile_shapes[2].kind = TileShape::Kind::solid;
  level.map.set({2, 11}, 1);
  for (int x = 4; x < 10; ++x) level.map.set({x, 11}, 2);
  const Scene scene = compile_scene(level);
  Body over_slope = body(1, {18, 70, 8, 8}), high = body(2, {50, 10, 8, 8});
  over_slope.foot = Foot::centre;
  const State state = state_of({over_slope, high});
  const auto drawing = drawn(scene, state, {}, only(overlay::floor_height));
  ASSERT_EQ(drawing.lines.size(), 2u) << "the floor of the other one is too far below to be of interest";
  EXPECT_EQ(drawing.lines[0].from, (Vec2{14, 93}));
  EXPECT_EQ(drawing.lines[0].to, (Vec2{30, 93}));
  EXPECT_EQ(drawing.lines[1].from, (Vec2{22, 78}));
  EXPECT_EQ(drawing.lines[1].to, (Vec2{22, 93}));
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "floor 93.00");
  const auto chosen = drawn(scene, state, {}, only(overlay::floor_height), 2);
  ASSERT_EQ(chosen.labels.size(), 2u);
  EXPECT_EQ(chosen.labels[1].text, "floor 88.00");
}

// A crate on a crate on the ground, and a disc on the shoulder of another one.
TEST(Overlays, FloorHeightIsTheBodyBelowWhereBodiesStop) {
  Level level;
  level.map = TileMap(30, 17);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  for (int x = 0; x < 30; ++x) level.map.set({x, 11}, 1);
  Scene scene = compile_scene(level);
  State state = state_of({body(1, {16, 80, 8, 8}), body(2, {20, 72, 8, 8}), body(3, {96, 68, 16, 16}),
                          body(4, {100, 40, 16, 16})});
  state.bodies[2].kind = state.bodies[3].kind = BodyKind::disc;
  const auto says = [&](BodyPairs pairs) {
    scene.tuning.shared.bodies = static_cast<double>(pairs);
    scene.features.pairs = pairs != BodyPairs::pass;
    scene.features.meets = pairs == BodyPairs::meet;
    std::vector<std::string> texts;
    for (const OverlayLabel& label : drawn(scene, state, {}, only(overlay::floor_height), 2).labels)
      texts.push_back(label.text);
    return texts;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(says(BodyPairs::pass), (Texts{"floor 88.00", "floor 88.00", "floor 88.00", "floor 88.00"}));
  EXPECT_EQ(says(BodyPairs::block),
            (Texts{"floor 88.00", "body 1 at 80.00", "floor 88.00", "body 3 at 68.00"}));
  EXPECT_EQ(says(BodyPairs::meet),
            (Texts{"floor 88.00", "body 1 at 80.00", "floor 88.00", "body 3 at 69.07"}))
      << "the disc is round";
  const auto chosen = drawn(scene, state, {}, only(overlay::floor_height), 2);
  for (const OverlayLine& line : chosen.lines)
    EXPECT_FALSE(line.from.y > 80 && line.from.x > 20 && line.from.x < 28) << "nothing below the crate";
}

// The floor under each x: level from x = 12, a ramp up from 16, level again at its top from 24.
TEST(Overlays, TheChosenBodyShowsTheFloorAlongItsWidth) {
  Level level;
  level.map = TileMap(30, 17);
  level.tile_shapes[1] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[2].kind = TileShape::Kind::solid;
  level.map.set({1, 11}, 2);
  level.map.set({2, 10}, 1);
  level.map.set({2, 11}, 2);
  const Scene scene = compile_scene(level);
  const State state = state_of({body(1, {12, 70, 8, 8})});
  const auto drawing = drawn(scene, state, {}, only(overlay::floor_height), 1);
  std::map<double, double> floor;  // by x
  for (const OverlayLine& line : drawing.lines) {
    if (line.to == line.from + Vec2{0, 1.5}) floor[line.from.x] = line.from.y;
  }
  EXPECT_EQ(floor,
            (std::map<double, double>{
                {12, 88}, {13, 88}, {14, 88}, {15, 88}, {16, 88}, {17, 87}, {18, 86}, {19, 85}, {20, 84}}));
}

TEST(Overlays, PenetrationIsTheOverlapAndTheWayOut) {
  Level level;
  level.map = TileMap(30, 17);
  level.tile_shapes[2].kind = TileShape::Kind::solid;
  for (int x = 0; x < 10; ++x) level.map.set({x, 11}, 2);
  const Scene scene = compile_scene(level);
  const State state = state_of({body(1, {20, 82, 8, 8}), body(2, {40, 80, 8, 8})});
  const auto drawing = drawn(scene, state, {}, only(overlay::penetration), 1);
  ASSERT_EQ(drawing.boxes.size(), 1u) << "the other one stands on the ground";
  EXPECT_EQ(drawing.boxes[0].box, (Rect{20, 88, 8, 2}));
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].to - drawing.lines[0].from, (Vec2{0, -2}));
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "in 2.00");
}

// 65,536 bodies in view took 2 s for each picture of the window.
TEST(Overlays, OfVeryManyBodiesTheFirstInViewAreDrawn) {
  std::vector<Body> bodies;
  StepRecord record;
  for (int i = 1; i <= 5000; ++i) {
    bodies.push_back(body(i, kBall));
    record.paths.push_back({.body = i, .from = kBall, .goal = {}, .to = {9, 9, 8, 8}});
  }
  OverlaySet overlays = only(overlay::boxes);
  overlays.set(overlay::swept_path, true);
  const auto drawing = drawn({}, state_of(bodies), record, overlays, 4900);
  EXPECT_EQ(drawing.boxes.size(), 3 * (kMaxDrawnBodies + 1)) << "each with the two boxes of its path";
  EXPECT_TRUE(drawing.is_cut);

  const Rect elsewhere{5000, 0, 100, 100};
  for (int i = 0; i < 4990; ++i) bodies[i].box = record.paths[i].from = record.paths[i].to = elsewhere;
  const auto few = drawn({}, state_of(bodies), record, overlays, 4900);
  EXPECT_EQ(few.boxes.size(), 3u * 10);
  EXPECT_FALSE(few.is_cut);
}

// Huge bodies deep in the ground took 1 ms each.
TEST(Overlays, TheWorkForBodiesInTheGroundIsBounded) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(140, 140);
  level.tile_shapes[2].kind = TileShape::Kind::solid;
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{2});
  const Scene scene = compile_scene(level);
  std::vector<Body> bodies;
  for (int i = 1; i <= 100; ++i) bodies.push_back(body(i, {40, 40, 1024, 1024}));
  bodies.push_back(body(101, {200, -6, 8, 8}));
  const auto drawing = drawn(scene, state_of(bodies), {}, only(overlay::penetration), 101);
  EXPECT_LE(drawing.work_left, 0);
  EXPECT_GE(drawing.work_left, -8 * kMaxQueryWork);
  EXPECT_TRUE(drawing.is_cut);
  EXPECT_EQ(drawing.boxes.size(), 1u) << "that of the chosen body";
  EXPECT_FALSE(drawn(scene, state_of({bodies[100]}), {}, only(overlay::penetration)).is_cut);
}

TEST(Overlays, SweptPathGoesFromContactToContact) {
  StepRecord record;
  record.contacts = {contact({0, 20, 80, 8}, {0, -1}, {4, 12})};
  record.paths = {{.body = 1, .from = {0, 8, 8, 8}, .goal = {12, 20}, .to = {10, 12, 8, 8}}};
  record.contacts[0].handled = true;
  const auto drawing = drawn({}, state_of({body(1, {10, 12, 8, 8})}), record, only(overlay::swept_path));
  ASSERT_EQ(drawing.boxes.size(), 3u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{0, 8, 8, 8}));
  EXPECT_EQ(drawing.boxes[1].box, (Rect{4, 12, 8, 8}));
  EXPECT_EQ(drawing.boxes[2].box, (Rect{10, 12, 8, 8}));
  ASSERT_EQ(drawing.lines.size(), 6u) << "for each part the paths of the centre and of two corners";
  EXPECT_EQ(drawing.lines[0].from, (Vec2{8, 8}))
      << "down and to the right, the top right corner is outermost";
  EXPECT_EQ(drawing.lines[0].to, (Vec2{12, 12}));
  EXPECT_EQ(drawing.lines[1].from, (Vec2{0, 16}));
  EXPECT_EQ(drawing.lines[2].from, (Vec2{4, 12}));
}

TEST(Overlays, TrailsFadeWithAge) {
  const std::vector<Trail> trails = {{{0, 0}, {4, 0}, {8, 0}}};
  OverlayDrawing drawing;
  add_trails(trails, &overlay::trails, kEverything, drawing);
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_LT(drawing.lines[0].strength, drawing.lines[1].strength);
  EXPECT_EQ(drawing.lines[1].strength, 1);
  EXPECT_EQ(drawing.lines[1].to, (Vec2{8, 0}));
}

TEST(NumberLabel, PartsOfNormalsAreShort) {
  EXPECT_EQ(one_decimal(-0.44721), "-.4");
  EXPECT_EQ(one_decimal(0.894), ".9");
  EXPECT_EQ(one_decimal(-1), "-1");
  EXPECT_EQ(one_decimal(-0.04), "0");
  EXPECT_EQ(one_decimal(0.96), "1");
}

TEST(NumberLabels, SmallDifferencesHaveDigits) {
  EXPECT_EQ(small_too(0), "0.00");
  EXPECT_EQ(small_too(1.234), "1.23");
  EXPECT_EQ(small_too(-0.005), "-0.01");
  EXPECT_EQ(small_too(9.5367e-07), "9.5e-07");
  EXPECT_EQ(small_too(-0.0012), "-1.2e-03");
}

TEST(VisitedBoxes, CellsHaveTheSizeOfTheLevelsTiles) {
  Stage stage;
  stage.kind = StageKind::searched;
  stage.cells = {{2, 3}};
  OverlayDrawing drawing;
  add_visited({&stage, 1}, {18, 12}, kEverything, drawing);
  ASSERT_EQ(drawing.boxes.size(), 1u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{36, 36, 18, 12}));
}

TEST(VisitedBoxes, ListCellsAndTestedItemsOnce) {
  Stage stage;
  stage.kind = StageKind::searched;
  stage.cells = {{2, 3}, {2, 3}};
  stage.tested = {{.role = TileRole::solid, .cell = {2, 3}, .body = 0, .box = {16, 24, 8, 8}},
                  {.role = TileRole::ball, .cell = {9, 9}, .body = 3, .box = {18.5, 20, 8, 8}}};
  OverlayDrawing drawing;
  add_visited({&stage, 1}, {}, kEverything, drawing);
  ASSERT_EQ(drawing.boxes.size(), 2u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{16, 24, 8, 8}));
  EXPECT_EQ(drawing.boxes[1].box, (Rect{18.5, 20, 8, 8})) << "where the body is, and not where it started";

  // The time grew with the square of their number.
  stage.tested.assign(20'000, stage.tested.back());
  for (std::size_t i = 0; i < stage.tested.size(); ++i) stage.tested[i].box.x = static_cast<double>(i) / 16;
  OverlayDrawing many;
  add_visited({&stage, 1}, {}, kEverything, many);
  EXPECT_EQ(many.boxes.size(), 10'000u);
  EXPECT_TRUE(many.is_cut);
}

}  // namespace talus::overlay_test
