// Rectangles and ellipses as polygons, mirror images, and polygons for solvers that know boxes alone.
#include <talus/collision/shape_forms.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "level/bump_boxes.h"

namespace talus::shape_forms_test {

using Kind = TileShape::Kind;
constexpr TileSize kTile{16, 16};

TileShape polygon(std::vector<Vec2> points, bool one_way = false) {
  TileShape shape;
  shape.kind = Kind::polygon;
  shape.one_way = one_way;
  shape.points = std::move(points);
  return shape;
}

double area_of(const TileShape& shape) {
  double area = 0;
  for (const Trapezoid& part : trapezoids_of(shape))
    area += (part.right - part.left) *
            (part.bottom_left - part.top_left + part.bottom_right - part.top_right) / 2;
  return area;
}

TEST(ShapeForms, ARectangleHasItsCorners) {
  EXPECT_EQ(polygon_of_rectangle({2, 3, 4, 5}).points, (std::vector<Vec2>{{2, 3}, {6, 3}, {6, 8}, {2, 8}}));
  EXPECT_EQ(polygon_of_rectangle({2, 3, 4, 5}, 90).points,
            (std::vector<Vec2>{{2, 3}, {2, 7}, {-3, 7}, {-3, 3}}));
  EXPECT_EQ(polygon_of_rectangle({2, 3, 4, 5}, -270).points, polygon_of_rectangle({2, 3, 4, 5}, 90).points);
  EXPECT_FALSE(problem_of(polygon_of_rectangle({0, 0, 8, 8}, 30), kTile));
  EXPECT_NEAR(area_of(polygon_of_rectangle({0, 0, 8, 8}, 30)), 64, 0.05);
}

TEST(ShapeForms, AnEllipseStaysWithinItsError) {
  for (const Vec2 size : {Vec2{16, 16}, {8, 3}, {200, 40}}) {
    const TileShape ellipse = polygon_of_ellipse({0, 0, size.x, size.y});
    EXPECT_FALSE(problem_of(ellipse, {64, 64}));
    EXPECT_EQ(ellipse.points.size() % 4, 0u);
    for (std::size_t i = 0; i < ellipse.points.size(); ++i) {
      const Vec2 a = ellipse.points[i], b = ellipse.points[(i + 1) % ellipse.points.size()];
      const Vec2 middle{(a.x + b.x) / 2 - size.x / 2, (a.y + b.y) / 2 - size.y / 2};
      const double part = std::hypot(middle.x / (size.x / 2), middle.y / (size.y / 2));
      EXPECT_LE((1 - part) * std::max(size.x, size.y) / 2, kEllipseError + 1e-9);
    }
  }
}

TEST(ShapeForms, MirrorImagesAreInTheirTile) {
  TileShape group;
  group.kind = Kind::group;
  group.parts = {polygon({{0, 0}, {4, 0}, {0, 8}}, true), {.kind = Kind::slope, .heights = {2, 8}}};
  const TileShape side = mirrored(group, kTile, ShapeMirror::left_right);
  EXPECT_EQ(side.parts[0].points, (std::vector<Vec2>{{16, 0}, {12, 0}, {16, 8}}));
  EXPECT_EQ(side.parts[1].heights, (std::vector<double>{8, 2}));
  const TileShape down = mirrored(group, kTile, ShapeMirror::up_down);
  EXPECT_EQ(down.parts[0].points, (std::vector<Vec2>{{0, 16}, {4, 16}, {0, 8}}));
  EXPECT_EQ(down.parts[0].side, TileShape::Side::ceiling);
  EXPECT_EQ(down.parts[1].side, TileShape::Side::ceiling);
  EXPECT_EQ(mirrored(down, kTile, ShapeMirror::up_down), group);
}

TEST(ShapeForms, PlacesAreInTheGroundOrNot) {
  const TileShape notch = polygon({{0, 0}, {8, 8}, {16, 0}, {16, 16}, {0, 16}});
  EXPECT_TRUE(is_in_ground(notch, kTile, {8, 9}));
  EXPECT_FALSE(is_in_ground(notch, kTile, {8, 7}));
  EXPECT_FALSE(is_in_ground(polygon(notch.points, true), kTile, {8, 9}));
  TileShape group;
  group.kind = Kind::group;
  group.parts = {notch, {.kind = Kind::slope, .heights = {16, 16}}};
  EXPECT_TRUE(is_in_ground(group, kTile, {8, 7}));
}

// ---- For bump.lua ----

BumpBox box(double x, double y, double w, double h) { return {{x, y, w, h}, {}}; }
BumpBox sloped(double x, double y, double w, double h, BumpLine line) { return {{x, y, w, h}, line}; }

TEST(BumpBoxes, OfAPolygonAreSlopesAroundFullBoxes) {
  const TileShape house = polygon({{0, 4}, {8, 0}, {8, 16}, {0, 12}});
  EXPECT_TRUE(bump_takes_all_of(house));
  EXPECT_THAT(bump_boxes(house, kTile), testing::ElementsAre(sloped(0, 0, 8, 4, {0, 4}), box(0, 4, 8, 8),
                                                             sloped(0, 12, 8, 4, {0, 4, true})));
  EXPECT_FALSE(article_takes_all_of(house, kTile)) << "it has a ceiling";
  EXPECT_TRUE(article_takes_all_of(polygon({{0, 4}, {8, 0}, {8, 12}, {0, 12}}), kTile));
}

TEST(BumpBoxes, OfAOneWayPolygonAreItsLines) {
  EXPECT_THAT(bump_boxes(polygon({{0, 4}, {8, 4}, {8, 9}, {0, 9}}, true), kTile),
              testing::ElementsAre(sloped(0, 4, 8, 1, {1, 1, false, true})));
}

TEST(BumpBoxes, LeaveOutSlantedGround) {
  const TileShape slanted = polygon({{0, 0}, {16, 14}, {16, 16}, {0, 2}});
  EXPECT_FALSE(bump_takes_all_of(slanted));
  EXPECT_TRUE(bump_boxes(slanted, kTile).empty());
}

}  // namespace talus::shape_forms_test
