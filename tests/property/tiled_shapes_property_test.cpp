// Random outlines of Tiled's tiles: floors and ceilings are read exactly, and other outlines never without a
// warning.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "formats/tiled/tiled_objects.h"
#include "formats/tiled/tiled_shapes.h"

namespace talus::tiled_shapes_property_test {

using Points = std::vector<Vec2>;

TileShape random_shape() {
  TileShape shape;
  shape.kind = TileShape::Kind::profile;
  shape.side = *rc::gen::arbitrary<bool>() ? TileShape::Side::floor : TileShape::Side::ceiling;
  shape.tiles = *rc::gen::inRange(1, kMaxShapeTiles + 1);
  const int count = *rc::gen::element(2, 3, 4, 5, 8, 9, 17, 65);
  for (int i = 0; i < count; ++i)
    shape.heights.push_back(*rc::gen::element(0, 0, 8, 8, *rc::gen::inRange(0, 64 * 256 + 1) / 256.0));
  return shape;
}

// The same line with as few heights as possible.
TileShape simplest(TileShape shape) {
  const std::size_t parts = shape.heights.size() - 1;
  for (std::size_t fewer = 1; fewer <= parts; ++fewer) {
    if (parts % fewer != 0) continue;
    const std::size_t step = parts / fewer;
    const auto height = [&](std::size_t i) {
      const double a = shape.heights[i / step * step],
                   b = shape.heights[std::min(i / step + 1, fewer) * step];
      return a + (b - a) * static_cast<double>(i % step) / static_cast<double>(step);
    };
    bool is_same = true;
    for (std::size_t i = 0; i <= parts; ++i)
      is_same = is_same && std::abs(height(i) - shape.heights[i]) < 1e-9;
    if (!is_same) continue;
    std::vector<double> heights;
    for (std::size_t i = 0; i <= parts; i += step) heights.push_back(shape.heights[i]);
    shape.heights = std::move(heights);
    break;
  }
  shape.kind = shape.heights.size() == 2 ? TileShape::Kind::slope : TileShape::Kind::profile;
  return shape;
}

// The outline as another program may draw it: in the opposite order, from another point on, with points in
// between, at an offset.
TiledObject redrawn(TiledObject object) {
  Points points;
  const auto count = object.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 from = object.points[i], to = object.points[(i + 1) % count];
    points.push_back(from);
    if (*rc::gen::inRange(0, 4) == 0) points.push_back({(from.x + to.x) / 2, (from.y + to.y) / 2});
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), points.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(points)),
              points.end());
  object.position = {*rc::gen::inRange(-64, 64) / 4.0, *rc::gen::inRange(-64, 64) / 4.0};
  for (Vec2& p : points) p = p - object.position;
  object.points = std::move(points);
  return object;
}

RC_GTEST_PROP(TiledShapesProperty, FloorsAndCeilingsAreReadExactly, ()) {
  const TileShape shape = simplest(random_shape());
  const auto all_are = [&](double height) {
    return std::all_of(shape.heights.begin(), shape.heights.end(), [&](double h) { return h == height; });
  };
  RC_PRE(!all_are(0) && !all_are(8));  // neither empty nor a box, which is both a floor and a ceiling
  const bool one_way = *rc::gen::arbitrary<bool>();
  const auto found = tile_shape_of(outline_of(redrawn(tiled_objects(shape, {}).at(0))), one_way, {});
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->heights == shape.heights);
  RC_ASSERT(found->kind == shape.kind);
  RC_ASSERT(found->side == shape.side);
  RC_ASSERT(found->tiles == shape.tiles);
  RC_ASSERT(found->one_way == one_way);
}

// The area in px² that is in only one of the shape and the outline (even-odd), in columns of 1/16 px.
double difference(const Points& outline, const TileShape& shape) {
  constexpr double kStep = 1.0 / 16;
  const double width = shape.tiles * kCartTileSize;
  double area = 0;
  for (double x = -16 + kStep / 2; x < 80; x += kStep) {
    std::vector<double> ys;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      if ((a.x < x) != (b.x < x)) ys.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
    }
    if (x > 0 && x < width) {
      const bool is_solid = shape.kind == TileShape::Kind::solid;
      const std::vector<double> heights = is_solid ? std::vector<double>{8, 8} : shape.heights;
      const double at = x / width * static_cast<double>(heights.size() - 1);
      const auto part = static_cast<std::size_t>(at);
      const double h = heights[part] + (heights[part + 1] - heights[part]) * (at - std::floor(at));
      ys.insert(ys.end(), {shape.side == TileShape::Side::floor ? 8 - h : 0,
                           shape.side == TileShape::Side::floor ? 8 : h});
    }
    std::sort(ys.begin(), ys.end());  // between the crossings of each pair the two differ
    for (std::size_t i = 0; i + 1 < ys.size(); i += 2) area += (ys[i + 1] - ys[i]) * kStep;
  }
  return area;
}

// Corners where people put them: often on the tile's own corners.
Points random_outline() {
  Points outline;
  for (int i = *rc::gen::inRange(3, 7); i > 0; --i) {
    const double x = *rc::gen::inRange(-8, 40) / 2.0, y = *rc::gen::inRange(-20, 24) / 2.0;
    outline.push_back({*rc::gen::element(0.0, 0.0, 4.0, 8.0, 8.0, 16.0, x),
                       *rc::gen::element(0.0, 0.0, 4.0, 8.0, 8.0, -8.0, y)});
  }
  return outline;
}

TEST(TiledShapesProperty, APolygonMatchesTheShapeThatIsReadFromIt) {
  int taken = 0, nearest_ones = 0;
  EXPECT_TRUE(rc::check([&] {
    for (int round = 0; round < 10; ++round) {
      const Points outline = random_outline();
      if (const auto shape = tile_shape_of(outline, false, {})) {
        ++taken;  // heights are rounded to 1/256 px
        RC_ASSERT(difference(outline, *shape) < 0.05);
      } else if (const auto nearest = nearest_tile_shape(outline, {})) {
        ++nearest_ones;
        RC_ASSERT(!problem_of(nearest->shape, {}));
        if (nearest->shape.one_way) continue;
        // Both areas are sums over columns, which differ where an outline is steep.
        RC_ASSERT(std::abs(difference(outline, nearest->shape) - nearest->more - nearest->less) < 2.0);
      }
    }
  }));
  EXPECT_GT(taken, 10);
  EXPECT_GT(nearest_ones, 100);
}

}  // namespace talus::tiled_shapes_property_test
