// Polygons are cut into triangles in exact arithmetic, and not as the core cuts them.
#include "random_polygons.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

using reference::Exact;
using reference::ExactPoint;
using reference::Part;
using ShapeKind = TileShape::Kind;
using ShapeSide = TileShape::Side;

TileShape polygon_of(std::vector<Vec2> points) {
  TileShape shape;
  shape.kind = ShapeKind::polygon;
  shape.points = std::move(points);
  return shape;
}

// Points in any order; few of them make a simple polygon.
std::vector<Vec2> scattered(Dice& dice, TileSize tile) {
  const double far = dice.one_in(3) ? 1 : 0, w = tile.width, h = tile.height;
  const double parts = dice.one_in(4) ? 256 : dice.one_in(2) ? 1 : 4 / std::min({w, h, 4.0});
  std::vector<Vec2> points(static_cast<std::size_t>(3 + dice.up_to(4)));
  for (Vec2& p : points)
    p = {dice.step(-far * w, (1 + far) * w, parts), dice.step(-far * h, (1 + far) * h, parts)};
  return points;
}

// Like a comb: teeth that hang from a back, or stand on it.
std::vector<Vec2> comb(Dice& dice, TileSize tile) {
  const int teeth = 1 + dice.up_to(2);
  const double w = tile.width, h = tile.height, back = dice.one_in(2) ? h : 0;
  std::vector<Vec2> points = {{0, back}};
  for (int i = 0; i < 2 * teeth + 1; ++i) {
    const double x = w * i / (2 * teeth);
    points.push_back({x, h * (i % 2 == 0 ? 1 + dice.up_to(1) : 3) / 4});
  }
  points.push_back({w, back});
  return points;
}

std::vector<Vec2> rectangle(Dice& dice, TileSize tile) {
  const double w = tile.width, h = tile.height;
  const double x0 = dice.step(0, w / 2, 4), x1 = x0 + dice.step(0.25, w / 2, 4);
  const double y0 = dice.step(0, h / 2, 4), y1 = y0 + dice.step(0.25, h / 2, 4);
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Exact exact(double value) { return reference::rounded_to_256th(value); }

Exact turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Cuts off corners until none is left.
std::vector<std::vector<ExactPoint>> triangles_of(std::vector<ExactPoint> points) {
  Exact area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactPoint &a = points[i], &b = points[(i + 1) % points.size()];
    area += a.x * b.y - b.x * a.y;
  }
  if (area < 0) std::reverse(points.begin(), points.end());
  std::vector<std::vector<ExactPoint>> triangles;
  for (std::size_t i = 0, tries = 0; points.size() > 2 && tries < 2 * points.size(); ++tries, ++i) {
    const std::size_t n = points.size();
    const ExactPoint a = points[i % n], b = points[(i + 1) % n], c = points[(i + 2) % n];
    const Exact size = turn(a, b, c);
    const auto blocks = [&](const ExactPoint& p) {
      const auto is = [&p](const ExactPoint& q) { return p.x == q.x && p.y == q.y; };
      return !is(a) && !is(b) && !is(c) && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    };
    if (size < 0 || (size > 0 && std::any_of(points.begin(), points.end(), blocks))) continue;
    if (size > 0) triangles.push_back({a, b, c});
    points.erase(points.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
    tries = 0;
  }
  return triangles;
}

bool is_in_polygon(const std::vector<Vec2>& points, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = weld(points[i]), b = weld(points[(i + 1) % points.size()]);
    if ((a.y > y) == (b.y > y)) continue;
    if (x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace

TileShape random_polygon(Dice& dice, TileSize tile, bool one_way) {
  TileShape shape = polygon_of(rectangle(dice, tile));
  for (int tries = 0; tries < 40; ++tries) {
    const TileShape other = polygon_of(dice.one_in(8) ? comb(dice, tile) : scattered(dice, tile));
    if (problem_of(other, tile)) continue;
    shape = other;
    break;
  }
  if (dice.one_in(2)) std::reverse(shape.points.begin(), shape.points.end());
  shape.one_way = one_way && dice.one_in(3);
  shape.side = dice.one_in(3) ? ShapeSide::ceiling : ShapeSide::floor;
  return shape;
}

TileShape random_group(Dice& dice, TileSize tile, bool one_way) {
  TileShape group;
  group.kind = ShapeKind::group;
  for (int count = 1 + dice.up_to(3); count > 0; --count) {
    if (dice.one_in(8)) {
      group.parts.push_back({.kind = ShapeKind::solid, .one_way = one_way && dice.one_in(2)});
    } else if (dice.one_in(4)) {
      TileShape part;
      part.kind = dice.one_in(2) ? ShapeKind::profile : ShapeKind::slope;
      part.side = dice.one_in(2) ? ShapeSide::ceiling : ShapeSide::floor;
      part.one_way = one_way && dice.one_in(3);
      for (int n = part.kind == ShapeKind::slope ? 2 : 3; n > 0; --n)
        part.heights.push_back(std::max(dice.step(0, tile.height, 1), part.one_way ? 1.0 : 0.0));
      group.parts.push_back(part);
    } else {
      group.parts.push_back(random_polygon(dice, tile, one_way));
    }
  }
  return group;
}

ShapeReach reach_of(const TileShape& shape, TileSize tile) {
  ShapeReach reach;
  for (const Vec2 p : shape.points) {
    reach.left = std::min(reach.left, static_cast<int>(std::floor(p.x / tile.width)));
    reach.top = std::min(reach.top, static_cast<int>(std::floor(p.y / tile.height)));
    reach.right = std::max(reach.right, static_cast<int>(std::ceil(p.x / tile.width)) - 1);
    reach.bottom = std::max(reach.bottom, static_cast<int>(std::ceil(p.y / tile.height)) - 1);
  }
  for (const TileShape& part : shape.parts) {
    const ShapeReach other = reach_of(part, tile);
    reach = {std::min(reach.left, other.left), std::min(reach.top, other.top),
             std::max(reach.right, other.right), std::max(reach.bottom, other.bottom)};
  }
  return reach;
}

TileShape mirrored_in_tile(const TileShape& shape, TileSize tile) {
  TileShape m = shape;
  std::reverse(m.heights.begin(), m.heights.end());
  for (Vec2& point : m.points) point.x = tile.width - point.x;
  for (TileShape& part : m.parts) part = mirrored_in_tile(part, tile);
  return m;
}

void add_polygon(const TileShape& polygon, TileSize tile, int column, int row, std::vector<Part>& parts) {
  std::vector<ExactPoint> points;
  for (const Vec2 p : polygon.points)
    points.push_back({exact(p.x) + column * tile.width, exact(p.y) + row * tile.height});
  if (!polygon.one_way) {
    for (auto& triangle : triangles_of(points)) {
      Part part;
      part.corners = std::move(triangle);
      parts.push_back(std::move(part));
    }
    return;
  }
  Exact area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactPoint &a = points[i], &b = points[(i + 1) % points.size()];
    area += a.x * b.y - b.x * a.y;
  }
  const bool is_floor = polygon.side == ShapeSide::floor;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ExactPoint a = points[i], b = points[(i + 1) % points.size()];
    if (area < 0) std::swap(a, b);
    if (is_floor ? a.x >= b.x : a.x <= b.x) continue;
    if (!is_floor) std::swap(a, b);
    parts.push_back({a, b, {}, is_floor ? Part::Stops::from_above : Part::Stops::from_below, {}});
  }
}

bool is_inside(const TileShape& shape, TileSize tile, double x, double y) {
  if (shape.kind == ShapeKind::group)
    return std::any_of(shape.parts.begin(), shape.parts.end(),
                       [&](const TileShape& part) { return is_inside(part, tile, x, y); });
  if (shape.one_way || shape.kind == ShapeKind::none) return false;
  if (shape.kind == ShapeKind::polygon) return is_in_polygon(shape.points, x, y);
  if (x <= 0 || x >= shape.tiles * tile.width) return false;
  const bool floor = shape.side == ShapeSide::floor || shape.kind == ShapeKind::solid;
  const double from_base = floor ? tile.height - y : y;
  if (shape.kind == ShapeKind::solid) return from_base > 0 && from_base < tile.height;
  const double step = shape.tiles * tile.width / static_cast<double>(shape.heights.size() - 1);
  std::size_t i = 0;
  while (i + 2 < shape.heights.size() && x > weld(step * static_cast<double>(i + 1))) ++i;
  const double x0 = weld(step * static_cast<double>(i)), x1 = weld(step * static_cast<double>(i + 1));
  const double h0 = weld(shape.heights[i]), h1 = weld(shape.heights[i + 1]);
  return from_base > 0 && from_base < h0 + (h1 - h0) * (x - x0) / (x1 - x0);
}

}  // namespace talus
