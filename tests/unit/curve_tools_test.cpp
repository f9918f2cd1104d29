// Curves: drawn between two points, bent by their handles and found by the mouse; and where points snap to.
#include "edit/curve_tools.h"

#include <gtest/gtest.h>

#include "edit/snap.h"

namespace talus::curve_tools_test {

using Faces = Curve::Faces;

// 20x10 cells, 160x80 px.
Level level_for_curves() {
  Level level;
  level.map = TileMap(20, 10);
  return level;
}

Level with_curve(Level level, const tl::expected<Edit, std::string>& edit) {
  EXPECT_TRUE(edit) << edit.error();
  if (edit) apply_edit(level, *edit);
  return level;
}

Curve drawn_curve(CurveKind kind, Vec2 a, Vec2 b) {
  return with_curve(level_for_curves(), add_curve(level_for_curves(), kind, a, b)).curves.at(0).curve;
}

void expect_near(Vec2 found, Vec2 expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
}

TEST(CurveTools, SegmentStopsBodiesOnTheLeftOfItsWay) {
  const auto added = [](Vec2 a, Vec2 b) { return drawn_curve(CurveKind::segment, a, b); };
  EXPECT_EQ(added({8, 40}, {80, 30}), (Curve{Segment{{8, 40}, {80, 30}}, Faces::up}));
  EXPECT_EQ(added({80, 30}, {8, 40}), (Curve{Segment{{8, 40}, {80, 30}}, Faces::down}));
  EXPECT_EQ(added({8, 40}, {8, 20}), (Curve{Segment{{8, 20}, {8, 40}}, Faces::up}));  // to the left
  EXPECT_EQ(added({8, 20}, {8, 40}), (Curve{Segment{{8, 20}, {8, 40}}, Faces::down}));
}

TEST(CurveTools, EveryKindGoesFromEndToEnd) {
  EXPECT_EQ(drawn_curve(CurveKind::arc, {16, 40}, {80, 40}),
            (Curve{Arc{{48, 64}, 40, 16, 80, true}, Faces::up}))
      << "a quarter of its width high";
  EXPECT_EQ(drawn_curve(CurveKind::parabola, {80, 40}, {16, 40}),
            (Curve{Parabola{{16, 40}, {80, 40}, 8}, Faces::down}))
      << "drawn to the left: a ceiling";
  EXPECT_EQ(drawn_curve(CurveKind::cubic, {16, 40}, {80, 24}),
            (Curve{Cubic{{16, 40}, {80, 24}, 0, 0}, Faces::up}));
  EXPECT_EQ(drawn_curve(CurveKind::cubic, {16, 40}, {80, 40}),
            (Curve{Cubic{{16, 40}, {80, 40}, -1, 1}, Faces::up}));
  EXPECT_EQ(drawn_curve(CurveKind::sine, {16, 40}, {80, 32}),
            (Curve{Sine{16, 80, 40, -8, 64, 16}, Faces::up}));
  EXPECT_EQ(drawn_curve(CurveKind::polyline, {16, 40}, {40, 34}),
            (Curve{Polyline{16, 40, {40, 38, 36, 34}}, Faces::up}));
}

TEST(CurveTools, SteepArcsStayFunctions) {
  const Curve steep = drawn_curve(CurveKind::arc, {16, 72}, {24, 8});
  EXPECT_FALSE(problem_of(steep));
  const auto [first, last] = ends_of_curve(steep);
  expect_near(first, {16, 72},
              0.3);  // the arc is vertical there, so its height is only as exact as a root of 1/256 px
  expect_near(last, {24, 8}, 0.3);
}

TEST(CurveTools, AnImpossibleCurveSaysWhyAndChangesNothing) {
  const Level level = level_for_curves();
  EXPECT_EQ(add_curve(level, CurveKind::arc, {8, 8}, {8, 8}).error(), "drag from one end to the other");
  EXPECT_EQ(add_curve(level, CurveKind::segment, {8, 8}, {8, 200}).error(),
            "the segment has its last end off the map");
  EXPECT_EQ(add_curve(level, CurveKind::arc, {8, 8}, {8, 40}).error(), "the arc has a width of zero");
  EXPECT_EQ(add_curve(level, CurveKind::sine, {8, 8}, {8, 40}).error(), "the sine has a width of zero");
  const Level arc = with_curve(level, add_curve(level, CurveKind::arc, {16, 40}, {80, 40}));
  LevelCurve turned = arc.curves[0];
  turned.curve = with_handle(turned.curve, 0, {90, 40});
  EXPECT_EQ(change_curve(arc, 0, turned, "Bend").error(), "the arc has its right end left of its left end");
}

TEST(CurveTools, LabelsAndTitles) {
  Level level = level_for_curves();
  const auto edit = add_curve(level, CurveKind::arc, {16, 40}, {80, 40});
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->label, "Add an arc");
  level = with_curve(level, edit);
  EXPECT_EQ(title_of(level, 0), "arc 0");
  level.curves[0].name = "hill";
  EXPECT_EQ(title_of(level, 0), "hill");
  EXPECT_EQ(remove_curve(level, 0).label, "Remove an arc");
}

TEST(CurveTools, SegmentsHandlesMoveItsEndsAndKeepItsSide) {
  const Curve floor{Segment{{16, 40}, {80, 32}}, Faces::up};
  EXPECT_EQ(handles_of(floor), (std::vector<Vec2>{{16, 40}, {80, 32}}));
  EXPECT_EQ(with_handle(floor, 1, {72, 16}), (Curve{Segment{{16, 40}, {72, 16}}, Faces::up}));
  EXPECT_EQ(with_handle(floor, 1, {8, 40}), (Curve{Segment{{8, 40}, {16, 40}}, Faces::down}))
      << "turned over";
  const Curve wall{Segment{{16, 8}, {16, 40}}, Faces::up};  // faces left: drawn upwards
  EXPECT_EQ(with_handle(wall, 0, {20, 8}), (Curve{Segment{{16, 40}, {20, 8}}, Faces::up}));
}

TEST(CurveTools, ArcsHandleBulgesIt) {
  const Curve arc{Arc{{48, 64}, 40, 16, 80, true}, Faces::up};
  EXPECT_EQ(handles_of(arc), (std::vector<Vec2>{{16, 40}, {80, 40}, {48, 24}}));
  EXPECT_EQ(with_handle(arc, 2, {48, 8}), (Curve{Arc{{48, 40}, 32, 16, 80, true}, Faces::up}));
  EXPECT_EQ(with_handle(arc, 2, {48, 0}), (Curve{Arc{{48, 40}, 32, 16, 80, true}, Faces::up}))
      << "no more than a half circle";
  EXPECT_EQ(with_handle(arc, 2, {48, 56}), (Curve{Arc{{48, 16}, 40, 16, 80, false}, Faces::up})) << "a bowl";
  EXPECT_EQ(with_handle(arc, 1, {48, 40}), (Curve{Arc{{32, 52}, 20, 16, 48, true}, Faces::up}))
      << "as round as before";
}

TEST(CurveTools, HandlesOfTheOtherKinds) {
  const Curve parabola{Parabola{{16, 40}, {80, 40}, 8}, Faces::up};
  EXPECT_EQ(handles_of(parabola)[2], (Vec2{48, 8}));
  EXPECT_EQ(with_handle(parabola, 2, {50, 20}), (Curve{Parabola{{16, 40}, {80, 40}, 20}, Faces::up}));
  const Curve cubic{Cubic{{0, 40}, {60, 40}, 0, 0}, Faces::up};
  EXPECT_EQ(handles_of(cubic)[2], (Vec2{20, 40}));
  EXPECT_EQ(with_handle(cubic, 2, {20, 30}), (Curve{Cubic{{0, 40}, {60, 40}, -0.5, 0}, Faces::up}));
  EXPECT_EQ(with_handle(cubic, 3, {40, 30}), (Curve{Cubic{{0, 40}, {60, 40}, 0, 0.5}, Faces::up}));
  const Curve sine{Sine{16, 80, 40, -8, 32, 0}, Faces::up};
  EXPECT_EQ(handles_of(sine)[2], (Vec2{32, 40})) << "the handle is at the first zero within the curve";
  EXPECT_EQ(handles_of(sine)[3], (Vec2{40, 32}));
  EXPECT_EQ(with_handle(sine, 2, {36, 44}), (Curve{Sine{16, 80, 44, -8, 32, 36}, Faces::up}));
  EXPECT_EQ(with_handle(sine, 3, {48, 20}), (Curve{Sine{16, 80, 40, -20, 64, 32}, Faces::up}));
  const Curve line{Polyline{16, 40, {40, 38, 36, 34}}, Faces::up};
  EXPECT_EQ(handles_of(line)[1], (Vec2{24, 38}));
  EXPECT_EQ(with_handle(line, 1, {27, 20}), (Curve{Polyline{16, 40, {40, 20, 36, 34}}, Faces::up}));
  EXPECT_EQ(with_handle(line, 3, {64, 20}), (Curve{Polyline{16, 64, {40, 38, 36, 20}}, Faces::up}));
}

TEST(CurveTools, TheNearestCurveWithinReachIsFound) {
  Level level = level_for_curves();
  EXPECT_EQ(curve_at(level, {8, 8}, 4), -1);
  for (const double y : {40.0, 46.0})
    level = with_curve(level, add_curve(level, CurveKind::segment, {8, y}, {80, y}));
  level.curves.push_back({"hill", {Arc{{40, 44}, 40, 0, 80, true}}, ""});
  level.curves.push_back({"bad", {Arc{{40, 44}, 4, 0, 80, true}}, ""});
  EXPECT_EQ(curve_at(level, {30, 51}, 4), -1);
  EXPECT_EQ(curve_at(level, {84, 49}, 4), -1) << "beyond its end";
  EXPECT_EQ(curve_at(level, {30, 44}, 4), 1);
  EXPECT_EQ(curve_at(level, {30, 42}, 4), 0);
  EXPECT_EQ(curve_at(level, {40, 6}, 4), 2);
  const Edit removed = remove_curve(level, 1);
  apply_edit(level, removed);
  EXPECT_EQ(curve_at(level, {30, 46}, 4), -1);
}

TEST(CurveTools, ACopyIsBesideTheCurveOnTheMap) {
  Level level = level_for_curves();
  level = with_curve(level, add_curve(level, CurveKind::segment, {0, 0}, {160, 80}));
  level.curves[0].name = "ramp";
  const auto none = duplicate_curve(level, 0);
  EXPECT_FALSE(none) << "as wide as the map";
  level.curves[0].curve = {Segment{{88, 8}, {160, 40}}, Faces::down};
  level = with_curve(level, duplicate_curve(level, 0));
  EXPECT_EQ(level.curves[1], (LevelCurve{"ramp", {Segment{{80, 16}, {152, 48}}, Faces::down}, ""}));
}

TEST(CurveTools, PointsFollowTheLine) {
  const Curve sine{Sine{16, 80, 40, 8, 64, 16}, Faces::up};
  const auto points = points_of(sine, 0, 48, 2);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0], (Vec2{16, 40}));
  expect_near(points[1], {32, 48}, 1e-9);
  expect_near(points[2], {48, 40}, 1e-9);
  const Curve line{Polyline{0, 40, {0, 8, 0, 8, 0}}, Faces::up};
  EXPECT_EQ(points_of(line, 12, 18, 99), (std::vector<Vec2>{{10, 8}, {20, 0}}));
  EXPECT_TRUE(points_of(line, 50, 60, 99).empty());
}

TEST(Snapping, ToPixelsBordersEndsAndHalves) {
  Level level = level_for_curves();
  using To = SnappedPoint::To;
  const auto at = [&](Vec2 p, SnapRules rules) { return snap(level, p, rules); };
  EXPECT_EQ(at({12.4, 19.6}, {.zoom = 4}), (SnappedPoint{{12, 20}, To::pixel}));
  EXPECT_EQ(at({17.4, 20.2}, {.zoom = 1}), (SnappedPoint{{16, 20}, To::tile}));
  EXPECT_EQ(at({17.4, 20.2}, {.zoom = 4}), (SnappedPoint{{17, 20}, To::pixel})) << "the hand is more exact";
  EXPECT_EQ(at({12.3, 19.8}, {.zoom = 4, .halves = true}), (SnappedPoint{{12.5, 20}, To::half}));
  EXPECT_EQ(at({12.3, 19.8}, {.zoom = 4, .off = true}),
            (SnappedPoint{{12.30078125, 19.80078125}, To::nothing}));
  level.curves.push_back({"", {Segment{{8, 8}, {41.5, 20.25}}}, ""});
  EXPECT_EQ(at({41, 21}, {.zoom = 4}), (SnappedPoint{{41.5, 20.25}, To::end}));
  EXPECT_EQ(at({41, 21}, {.zoom = 4, .without_curve = 0}), (SnappedPoint{{41, 21}, To::pixel}));
}

TEST(Snapping, ToTheEndsOfSlopedTiles) {
  Level level = level_for_curves();
  level.map.set({2, 3}, 7);
  level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {1.5, 6}};
  using To = SnappedPoint::To;
  EXPECT_EQ(snap(level, {16.3, 30}, {.zoom = 4}), (SnappedPoint{{16, 30.5}, To::end}));
  EXPECT_EQ(snap(level, {32.3, 25.5}, {.zoom = 4}), (SnappedPoint{{32, 26}, To::end}));
  level.tile_shapes[7].side = TileShape::Side::ceiling;
  EXPECT_EQ(snap(level, {32.3, 30.5}, {.zoom = 4}), (SnappedPoint{{32, 30}, To::end}));
}

}  // namespace talus::curve_tools_test
