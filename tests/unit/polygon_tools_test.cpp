// Polygons and groups as shapes of tiles: snapped, made of other shapes, and changed point by point.
#include "edit/polygon_tools.h"

#include <gtest/gtest.h>

#include <random>

#include <talus/collision/shape_forms.h>
#include "edit/tile_shapes.h"

namespace talus::polygon_tools_test {

using Kind = TileShape::Kind;
using Side = TileShape::Side;
using Points = std::vector<Vec2>;

constexpr TileSize kSmall{8, 8}, kWide{18, 12}, kLarge{64, 64};

TileShape polygon(Points points) { return {.kind = Kind::polygon, .points = std::move(points)}; }
TileShape line(Kind kind, std::vector<double> heights, int tiles = 1, Side side = Side::floor) {
  return {.kind = kind, .side = side, .tiles = tiles, .heights = std::move(heights)};
}
const TileShape kTriangle = polygon({{0, 8}, {8, 0}, {8, 8}});

TEST(PolygonTools, PointsSnapToTheGridOfTheTile) {
  const Vec2 place{8.6, 5.9};
  EXPECT_EQ(snapped(place, PointSnap::corners, kWide), (Vec2{0, 0}));
  EXPECT_EQ(snapped(place, PointSnap::halves, kWide), (Vec2{9, 6}));
  EXPECT_EQ(snapped(place, PointSnap::pixels, kWide), (Vec2{9, 6}));
  EXPECT_EQ(snapped(place, PointSnap::free, kWide), (Vec2{8.6015625, 5.8984375}));
  EXPECT_EQ(snapped({-9, 6}, PointSnap::corners, kWide), (Vec2{0, 12})) << "of two, the further one";
  EXPECT_EQ(snapped({-9.1, 5.9}, PointSnap::corners, kWide), (Vec2{-18, 0}));
  EXPECT_EQ(snapped({4.4, 4.6}, PointSnap::halves, {9, 9}), (Vec2{4.5, 4.5})) << "half of an odd size";
}

TEST(PolygonTools, StepsAreThoseOfTheGrid) {
  EXPECT_EQ(snap_step(PointSnap::corners, kWide), (Vec2{18, 12}));
  EXPECT_EQ(snap_step(PointSnap::halves, kWide), (Vec2{9, 6}));
  EXPECT_EQ(snap_step(PointSnap::pixels, kWide), (Vec2{1, 1}));
  EXPECT_EQ(snap_step(PointSnap::free, kWide), (Vec2{0.0625, 0.0625}));
}

TEST(PolygonTools, APointStaysWithinEightTiles) {
  EXPECT_EQ(with_point_at(kTriangle, 1, {500, -500}, kSmall).points[1], (Vec2{72, -64}));
  EXPECT_EQ(with_point_at(kTriangle, 1, {5.001, -3}, kSmall).points[1], (Vec2{5, -3})) << "welded";
  EXPECT_FALSE(problem_of(with_point_at(kTriangle, 1, {72, -64}, kSmall), kSmall));
}

TEST(PolygonTools, TheOutlineOfAFullTileIsItsRectangle) {
  EXPECT_EQ(
      as_polygon({.kind = Kind::solid, .one_way = true}, kWide),
      (TileShape{.kind = Kind::polygon, .one_way = true, .points = {{0, 0}, {18, 0}, {18, 12}, {0, 12}}}));
}

TEST(PolygonTools, TheOutlineOfASlopeEndsAtItsBase) {
  EXPECT_EQ(as_polygon(line(Kind::slope, {0, 8}), kSmall), polygon({{0, 8}, {8, 0}, {8, 8}}));
  EXPECT_EQ(as_polygon(line(Kind::slope, {4, 8}, 2), kSmall), polygon({{0, 4}, {16, 0}, {16, 8}, {0, 8}}));
  TileShape hanging = polygon({{0, 3}, {18, 0}, {0, 0}});
  hanging.side = Side::ceiling;
  EXPECT_EQ(as_polygon(line(Kind::slope, {3, 0}, 1, Side::ceiling), kWide), hanging);
}

TEST(PolygonTools, TheOutlineOfAProfileHasItsCornersAlone) {
  EXPECT_EQ(as_polygon(line(Kind::profile, {2, 4, 6, 6, 6}), kSmall),
            polygon({{0, 6}, {4, 2}, {8, 2}, {8, 8}, {0, 8}}));
}

TEST(PolygonTools, AProfileThatFallsToItsBaseIsAGroup) {
  const TileShape shape = as_polygon(line(Kind::profile, {4, 0, 0, 4, 0}), kSmall);
  EXPECT_EQ(shape,
            (TileShape{.kind = Kind::group,
                       .parts = {polygon({{0, 4}, {2, 8}, {0, 8}}), polygon({{4, 8}, {6, 4}, {8, 8}})}}));
  EXPECT_EQ(problem_of(shape, kSmall), std::nullopt);
}

TEST(PolygonTools, AOneWayLineKeepsAllOfItself) {
  TileShape shape = line(Kind::profile, {4, 0, 0, 4, 0});
  shape.one_way = true;
  const TileShape outline = as_polygon(shape, kSmall);
  EXPECT_EQ(outline.points, (Points{{0, 4}, {2, 8}, {4, 8}, {6, 4}, {8, 8}, {8, 9}, {0, 9}}));
  EXPECT_TRUE(outline.one_way);
  EXPECT_EQ(problem_of(outline, kSmall), std::nullopt);
}

TEST(PolygonTools, AFlatLineAtItsBaseBecomesAUsableStrip) {
  EXPECT_EQ(problem_of(as_polygon(line(Kind::slope, {0, 0}), kSmall), kSmall), std::nullopt);
  EXPECT_EQ(problem_of(as_polygon(line(Kind::slope, {0, 0}, 1, Side::ceiling), kSmall), kSmall),
            std::nullopt);
}

TEST(PolygonTools, OutlinesAreUsableAndHaveTheSameGround) {
  std::mt19937 random(20261123);
  for (int round = 0; round < 300; ++round) {
    const TileSize tile{static_cast<int>(random() % 40 + 2), static_cast<int>(random() % 40 + 1)};
    TileShape shape;
    shape.kind = random() % 2 == 0 ? Kind::slope : Kind::profile;
    shape.side = random() % 2 == 0 ? Side::floor : Side::ceiling;
    shape.tiles = static_cast<int>(random() % 3 + 1);
    const std::size_t count = shape.kind == Kind::slope ? 2 : random() % 6 + 3;
    for (std::size_t i = 0; i < count; ++i)
      shape.heights.push_back(static_cast<int>(random() % 4) * tile.height / 2.0);
    const TileShape outline = as_polygon(shape, tile);
    ASSERT_EQ(problem_of(outline, tile), std::nullopt) << round;
    for (int probe = 0; probe < 50; ++probe) {
      const Vec2 place{static_cast<int>(random() % 1000) / 1000.0 * shape.tiles * tile.width,
                       (static_cast<int>(random() % 3000) / 1000.0 - 1) * tile.height};
      const bool is_flat = std::ranges::all_of(shape.heights, [](double height) { return height == 0; });
      const Vec2 up{place.x, place.y - 0.01}, down{place.x, place.y + 0.01};
      if (is_flat || is_in_ground(shape, tile, up) != is_in_ground(shape, tile, down))
        continue;  // at its line
      EXPECT_EQ(is_in_ground(outline, tile, place), is_in_ground(shape, tile, place)) << round;
    }
  }
}

TEST(PolygonTools, ALineOfManyPointsIsThinned) {
  TileShape shape = line(Kind::profile, {});
  for (int i = 0; i <= 512; ++i) shape.heights.push_back(i % 2 + 1);
  const TileShape outline = as_polygon(shape, {256, 256});
  EXPECT_EQ(problem_of(outline, {256, 256}), std::nullopt);
  EXPECT_EQ(outline.points.front(), (Vec2{0, 255}));
}

TEST(PolygonTools, KindsBecomePolygonsAndLinesAgain) {
  const TileShape ramp = line(Kind::slope, {0, 12}, 2);
  const TileShape outline = with_kind(ramp, Kind::polygon, kWide);
  EXPECT_EQ(outline.kind, Kind::polygon);
  EXPECT_EQ(with_kind(outline, Kind::slope, kWide), ramp);
  EXPECT_EQ(with_kind({}, Kind::polygon, kWide), as_polygon({.kind = Kind::solid}, kWide));
  EXPECT_EQ(with_kind(polygon({{0, 4}, {8, 4}, {8, 8}, {0, 8}}), Kind::profile, kSmall),
            line(Kind::profile, std::vector<double>(9, 4)));
  EXPECT_EQ(with_kind(outline, Kind::solid, kWide), TileShape{.kind = Kind::solid});
}

TEST(PolygonTools, TheProfileAlongAGroupIsItsTop) {
  const TileShape group = with_new_part(kTriangle, polygon({{0, 6}, {4, 6}, {4, 8}, {0, 8}}));
  EXPECT_EQ(profile_along(group, kSmall).heights, (std::vector<double>{2, 2, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(profile_along(polygon({{0, 0}, {8, 8}, {8, 0}, {0, 8}}), kSmall).heights,
            std::vector<double>(9, 0))
      << "an invalid one has no ground";
}

TEST(PolygonTools, TheNearestPointAndSideAreFound) {
  const Points& points = kTriangle.points;
  EXPECT_EQ(point_near(points, {7, 1}, 2), 1u);
  EXPECT_EQ(point_near(points, {4, 4}, 2), std::nullopt);
  EXPECT_EQ(side_near(points, {4, 5}, 1), 0u);
  EXPECT_EQ(side_near(points, {7.5, 4}, 1), 1u);
  EXPECT_EQ(side_near(points, {3, 8.5}, 1), 2u) << "the last side goes back to the first point";
  EXPECT_EQ(side_near(points, {5, 6}, 0.5), std::nullopt);
  EXPECT_EQ(point_near({}, {0, 0}, 5), std::nullopt);
}

TEST(PolygonTools, APointIsInsertedWhereItSnaps) {
  const TileShape more = with_point_on(kTriangle, 1, {7.8, 3.7}, PointSnap::pixels, kSmall);
  EXPECT_EQ(more.points, (Points{{0, 8}, {8, 0}, {8, 4}, {8, 8}}));
  EXPECT_EQ(with_point_on(kTriangle, 2, {3, 8}, PointSnap::free, kSmall).points[3], (Vec2{3, 8}))
      << "after the last point";
}

TEST(PolygonTools, AnInsertedPointLeavesAPolygonUsable) {
  const TileShape at_pixel = with_point_on(kTriangle, 1, {8, 5}, PointSnap::corners, kSmall);
  EXPECT_EQ(at_pixel.points[2], (Vec2{8, 5})) << "the corner of the cell is a point already";
  const TileShape tiny = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const TileShape on_side = with_point_on(tiny, 0, {0.5, 0}, PointSnap::corners, kSmall);
  EXPECT_EQ(on_side.points[1], (Vec2{0.5, 0})) << "no whole px is free";
  EXPECT_EQ(problem_of(on_side, kSmall), std::nullopt);
}

TEST(PolygonTools, APointIsRemoved) {
  EXPECT_EQ(without_point(kTriangle, 1).points, (Points{{0, 8}, {8, 8}}));
  EXPECT_TRUE(problem_of(without_point(kTriangle, 1), kSmall)) << "which the shape editor does not do";
}

TEST(PolygonTools, APolygonIsMovedAsFarAsItGoes) {
  EXPECT_EQ(moved_by(kTriangle, {3, -2}, kSmall).points, (Points{{3, 6}, {11, -2}, {11, 6}}));
  const TileShape far = moved_by(kTriangle, {100, 1000}, kSmall);
  EXPECT_EQ(far.points, (Points{{64, 72}, {72, 64}, {72, 72}})) << "it keeps its form";
}

TEST(PolygonTools, PartsAreAddedReplacedAndRemoved) {
  const TileShape slope = line(Kind::slope, {0, 4});
  EXPECT_EQ(part_count({}), 0u);
  EXPECT_EQ(part_count(slope), 1u);
  EXPECT_EQ(with_new_part({}, slope), slope) << "one part is no group";
  const TileShape two = with_new_part(slope, kTriangle);
  ASSERT_EQ(two, (TileShape{.kind = Kind::group, .parts = {slope, kTriangle}}));
  const TileShape three = with_new_part(two, {.kind = Kind::solid});
  EXPECT_EQ(part_count(three), 3u);
  EXPECT_EQ(part_at(three, 2).kind, Kind::solid);
  EXPECT_EQ(part_at(slope, 0), slope);
  EXPECT_EQ(with_part_at(two, 0, kTriangle), with_new_part(kTriangle, kTriangle));
  EXPECT_EQ(with_part_at(two, 0, {}), kTriangle) << "the last part is no group";
  EXPECT_EQ(with_part_at(slope, 0, {}), TileShape());
  EXPECT_EQ(part_count(with_part_at(two, 1, two)), 3u) << "no group is a part of a group";
}

TEST(PolygonTools, ThePartUnderAPlaceIsFound) {
  TileShape platform = line(Kind::slope, {2, 2});
  platform.one_way = true;
  const TileShape group = with_new_part(kTriangle, platform);
  EXPECT_EQ(part_near(group, kSmall, {6, 4}, 0.5), 0u);
  EXPECT_EQ(part_near(group, kSmall, {2, 6.2}, 0.5), 1u) << "the later one lies on top";
  EXPECT_EQ(part_near(group, kSmall, {1, 1}, 0.5), std::nullopt);
}

// ---- Changes of several tiles ----

TEST(PolygonTools, SelectedTilesWithTheSameShapeChangeAlike) {
  Level level;
  level.tile_shapes[40] = level.tile_shapes[41] = kTriangle;
  level.tile_shapes[42] = line(Kind::slope, {0, 8});
  TileShape changed = with_point_at(kTriangle, 1, {4, 0}, kSmall);
  changed.one_way = true;
  apply_edit(level, change_shapes(level, {SheetId::tiles, {8, 2, 4, 1}}, changed));
  EXPECT_EQ(level.tile_shapes[40], changed);
  EXPECT_EQ(level.tile_shapes[41], changed);
  TileShape one_way = line(Kind::slope, {0, 8});
  one_way.one_way = true;
  EXPECT_EQ(level.tile_shapes[42], one_way) << "of another shape only what it has changes";
  EXPECT_EQ(level.tile_shapes[43], TileShape());
}

TEST(PolygonTools, KindsOfSelectedTilesBecomePolygons) {
  Level level;
  level.tile_shapes[40] = line(Kind::slope, {0, 8});
  level.tile_shapes[41] = {.kind = Kind::solid};
  apply_edit(level, change_kinds(level, {SheetId::tiles, {8, 2, 2, 1}}, Kind::polygon));
  EXPECT_EQ(level.tile_shapes[40], kTriangle);
  EXPECT_EQ(level.tile_shapes[41].points.size(), 4u);
}

TEST(PolygonTools, LargeTilesHaveTheSameTools) {
  const TileShape full = as_polygon({.kind = Kind::solid}, kLarge);
  EXPECT_EQ(full.points[2], (Vec2{64, 64}));
  EXPECT_EQ(with_point_on(full, 0, {33, 0}, PointSnap::halves, kLarge).points[1], (Vec2{32, 0}));
  EXPECT_EQ(with_point_at(full, 1, {-1000, 1000}, kLarge).points[1], (Vec2{-512, 576}));
}

}  // namespace talus::polygon_tools_test
