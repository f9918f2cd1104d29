// Angles are turned by sine_of_turns(), so that the points are the same on every machine.
#include <talus/collision/shape_forms.h>

#include <algorithm>
#include <cmath>

#include <talus/collision/piece.h>
#include "polygon_columns.h"
#include "tile_outlines.h"

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

// The direction at an angle clockwise from the right; exact for multiples of a quarter turn.
Vec2 direction(double turns) {
  const double quarters = std::floor(turns * 4), rest = turns - quarters / 4;
  const Vec2 first{cosine_of_turns(rest), sine_of_turns(rest)};
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 0:
      return first;
    case 1:
      return {-first.y, first.x};
    case 2:
      return {-first.x, -first.y};
    default:
      return {first.y, -first.x};
  }
}

Vec2 turned(Vec2 point, Vec2 about, Vec2 by) {
  const Vec2 d = point - about;
  return {about.x + d.x * by.x - d.y * by.y, about.y + d.x * by.y + d.y * by.x};
}

// The distance of the middle of a side from the circle of that radius.
double error_of(double radius, int points) { return radius * (1 - cosine_of_turns(0.5 / points)); }

Side other_side(Side side) { return side == Side::floor ? Side::ceiling : Side::floor; }

bool is_in_polygon(const std::vector<Vec2>& points, Vec2 place) {
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y > place.y) == (b.y > place.y)) continue;
    if (place.x < a.x + (b.x - a.x) * ((place.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

}  // namespace

TileShape polygon_of_rectangle(const Rect& box, double degrees) {
  TileShape shape;
  shape.kind = Kind::polygon;
  const Vec2 by = direction(degrees / 360);
  for (const Vec2 corner :
       {box.position(), Vec2{box.right(), box.y}, Vec2{box.right(), box.bottom()}, Vec2{box.x, box.bottom()}})
    shape.points.push_back(turned(corner, box.position(), by));
  return shape;
}

TileShape polygon_of_ellipse(const Rect& box, double degrees) {
  TileShape shape;
  shape.kind = Kind::polygon;
  const double radius = std::max(box.w, box.h) / 2;
  int count = 8;
  while (count < static_cast<int>(kMaxPolygonPoints) && error_of(radius, count) > kEllipseError) count += 4;
  const Vec2 by = direction(degrees / 360), center = box.center();
  for (int i = 0; i < count; ++i) {
    const Vec2 at = direction(static_cast<double>(i) / count);
    const Vec2 point{center.x + at.x * box.w / 2, center.y + at.y * box.h / 2};
    shape.points.push_back(turned(point, box.position(), by));
  }
  return shape;
}

TileShape mirrored(TileShape shape, TileSize tile, ShapeMirror mirror) {
  const bool left_right = mirror == ShapeMirror::left_right;
  if (left_right) std::reverse(shape.heights.begin(), shape.heights.end());
  if (!left_right && (has_heights(shape) || shape.kind == Kind::polygon)) shape.side = other_side(shape.side);
  for (Vec2& point : shape.points)
    point = left_right ? Vec2{tile.width - point.x, point.y} : Vec2{point.x, tile.height - point.y};
  for (TileShape& part : shape.parts) part = mirrored(part, tile, mirror);
  shape.conveyor = 0 - shape.conveyor;
  return shape;
}

std::vector<Trapezoid> trapezoids_of(const TileShape& polygon) {
  constexpr TileSize kNoBorders{1 << 20, 1 << 20};
  std::vector<TileColumn> columns;
  cut_polygon(polygon, 0, kNoBorders, columns);
  std::vector<Trapezoid> all;
  for (const TileColumn& part : columns) {
    const OutlineLine &top = part.top.front(), &bottom = part.bottom.front();
    all.push_back({part.left, part.right, top.at(part.left), top.at(part.right), bottom.at(part.left),
                   bottom.at(part.right)});
  }
  return all;
}

bool is_in_ground(const TileShape& shape, TileSize tile, Vec2 place) {
  if (shape.kind == Kind::group)
    return std::any_of(shape.parts.begin(), shape.parts.end(),
                       [&](const TileShape& part) { return is_in_ground(part, tile, place); });
  if (shape.one_way || shape.kind == Kind::none) return false;
  if (shape.kind == Kind::polygon) return is_in_polygon(shape.points, place);
  const double width = shape.kind == Kind::solid ? tile.width : shape.tiles * tile.width;
  if (place.x < 0 || place.x > width) return false;
  const bool is_floor = shape.kind == Kind::solid || shape.side == Side::floor;
  const double from_base = is_floor ? tile.height - place.y : place.y;
  return from_base >= 0 && from_base <= height_of_line(shape, place.x, tile);
}

}  // namespace talus
