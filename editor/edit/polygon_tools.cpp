// Changes points of polygons and parts of groups.
#include "polygon_tools.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <talus/collision/shape_forms.h>

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

double nearest_multiple(double number, double step) { return std::floor(number / step + 0.5) * step; }

// The nearest place on the line between two points.
Vec2 nearest_between(Vec2 from, Vec2 to, Vec2 place) {
  const Vec2 along = to - from;
  const double length = dot(along, along);
  if (length == 0) return from;
  return from + along * std::clamp(dot(place - from, along) / length, 0.0, 1.0);
}

double distance(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool is_straight(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x); }

TileShape polygon_through(std::vector<Vec2> points, const TileShape& like) {
  return {.kind = Kind::polygon,
          .side = like.side,
          .one_way = like.one_way,
          .points = std::move(points),
          .conveyor = like.conveyor};
}

// The line of a slope or profile from left to right, without the points at which it is straight.
std::vector<Vec2> line_points(const TileShape& shape, TileSize tile) {
  std::vector<Vec2> line;
  const double width = shape.tiles * tile.width, last = static_cast<double>(shape.heights.size() - 1);
  for (std::size_t i = 0; i < shape.heights.size(); ++i) {
    const double height = weld(shape.heights[i]), x = weld(width * static_cast<double>(i) / last);
    const Vec2 point{x, shape.side == Side::floor ? tile.height - height : height};
    while (line.size() > 1 && is_straight(line[line.size() - 2], line.back(), point)) line.pop_back();
    line.push_back(point);
  }
  return line;
}

// The ground between a line and a level base.
std::vector<Vec2> ring_of(std::vector<Vec2> line, double base) {
  while (line.size() + 2 > kMaxPolygonPoints) {
    std::vector<Vec2> thinner;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (i % 2 == 0 || i + 1 == line.size()) thinner.push_back(line[i]);
    line = std::move(thinner);
  }
  const Vec2 first = line.front(), last = line.back();
  if (last.y != base) line.push_back({last.x, base});
  if (first.y != base) line.push_back({first.x, base});
  return line;
}

// The stretches of a line in which it leaves its base.
std::vector<std::vector<Vec2>> stretches_off(double base, const std::vector<Vec2>& line) {
  std::vector<std::vector<Vec2>> all;
  bool goes_on = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const bool is_off = line[i - 1].y != base || line[i].y != base;
    if (is_off && !goes_on) all.push_back({line[i - 1]});
    if (is_off) all.back().push_back(line[i]);
    goes_on = is_off && line[i].y != base;
  }
  return all;
}

TileShape polygon_of_line(const TileShape& shape, TileSize tile) {
  const std::vector<Vec2> line = line_points(shape, tile);
  const bool is_floor = shape.side == Side::floor;
  const double base = is_floor ? tile.height : 0;
  const auto stretches = stretches_off(base, line);
  const bool touches = std::any_of(line.begin(), line.end(), [&](Vec2 point) { return point.y == base; });
  const bool fits =
      stretches.size() <= kMaxGroupParts && line.size() + 2 * stretches.size() <= kMaxGroupPoints;
  if (stretches.empty() || (shape.one_way && touches) || !fits)
    return polygon_through(ring_of(line, is_floor ? base + 1 : base - 1), shape);
  TileShape all;
  for (const auto& stretch : stretches)
    all = with_new_part(all, polygon_through(ring_of(stretch, base), shape));
  return all;
}

// How far the ground of usable polygons goes up, or down, at a place between left and right; nothing where
// there is no ground.
std::optional<double> end_of_ground(const std::vector<Trapezoid>& ground, double x, bool upwards) {
  std::optional<double> end;
  for (const Trapezoid& part : ground) {
    if (x < part.left || x > part.right) continue;
    const double along = (x - part.left) / (part.right - part.left);
    const double y = upwards ? std::lerp(part.top_left, part.top_right, along)
                             : std::lerp(part.bottom_left, part.bottom_right, along);
    if (!end || (upwards ? y < *end : y > *end)) end = y;
  }
  return end;
}

bool is_usable(const TileShape& shape, TileSize tile) { return !problem_of(shape, tile); }

}  // namespace

Vec2 snap_step(PointSnap snap, TileSize tile) {
  const double w = tile.width, h = tile.height;
  if (snap == PointSnap::corners) return {w, h};
  if (snap == PointSnap::halves) return {w / 2, h / 2};
  return snap == PointSnap::pixels ? Vec2{1, 1} : Vec2{1.0 / 16, 1.0 / 16};
}

Vec2 snapped(Vec2 place, PointSnap snap, TileSize tile) {
  if (snap == PointSnap::free) return weld(place);
  const Vec2 step = snap_step(snap, tile);
  return {nearest_multiple(place.x, step.x), nearest_multiple(place.y, step.y)};
}

Vec2 kept_near(Vec2 place, TileSize tile) {
  const double w = tile.width, h = tile.height;
  return {std::clamp(place.x, -kMaxShapeTiles * w, (kMaxShapeTiles + 1) * w),
          std::clamp(place.y, -kMaxShapeTiles * h, (kMaxShapeTiles + 1) * h)};
}

TileShape as_polygon(const TileShape& shape, TileSize tile) {
  if (shape.kind == Kind::solid) {
    TileShape all = polygon_of_rectangle({0, 0, 1.0 * tile.width, 1.0 * tile.height});
    all.one_way = shape.one_way;
    all.conveyor = shape.conveyor;
    return all;
  }
  if (has_heights(shape)) return polygon_of_line(shape, tile);
  if (shape.kind != Kind::group) return shape;
  TileShape all;
  for (const TileShape& part : shape.parts) all = with_new_part(all, as_polygon(part, tile));
  all.conveyor = shape.conveyor;
  return is_usable(all, tile) ? all : shape;
}

TileShape profile_along(const TileShape& shape, TileSize tile) {
  std::vector<Trapezoid> ground;
  double right = tile.width;
  for (std::size_t i = 0; i < part_count(shape) && is_usable(shape, tile); ++i) {
    const TileShape polygons = as_polygon(part_at(shape, i), tile);
    for (std::size_t k = 0; k < part_count(polygons); ++k) {
      for (const Trapezoid& part : trapezoids_of(part_at(polygons, k))) {
        ground.push_back(part);
        right = std::max(right, part.right);
      }
    }
  }
  const bool is_floor = shape.kind != Kind::polygon || shape.side == Side::floor;
  TileShape profile{.kind = Kind::profile, .side = is_floor ? Side::floor : Side::ceiling};
  profile.one_way = shape.kind == Kind::polygon && shape.one_way;
  profile.tiles = std::min(kMaxShapeTiles, static_cast<int>(std::ceil(right / tile.width)));
  const int columns = profile.tiles * tile.width, count = std::max(columns, 2);
  for (int i = 0; i <= count; ++i) {
    const double x = static_cast<double>(i) * columns / count;
    const double base = is_floor ? tile.height : 0, end = end_of_ground(ground, x, is_floor).value_or(base);
    profile.heights.push_back(
        std::clamp(is_floor ? base - end : end, 0.0, 1.0 * kMaxShapeTiles * tile.height));
  }
  return profile;
}

std::optional<std::size_t> point_near(const std::vector<Vec2>& points, Vec2 place, double reach) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = distance(points[i], place);
    if (away > reach) continue;
    reach = away;
    nearest = i;
  }
  return nearest;
}

std::optional<std::size_t> side_near(const std::vector<Vec2>& points, Vec2 place, double reach) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = distance(nearest_between(points[i], points[(i + 1) % points.size()], place), place);
    if (away > reach) continue;
    reach = away;
    nearest = i;
  }
  return nearest;
}

TileShape with_point_at(TileShape polygon, std::size_t point, Vec2 place, TileSize tile) {
  assert(point < polygon.points.size());
  polygon.points[point] = weld(kept_near(place, tile));
  return polygon;
}

TileShape with_point_on(TileShape polygon, std::size_t side, Vec2 place, PointSnap snap, TileSize tile) {
  assert(side < polygon.points.size());
  const Vec2 from = polygon.points[side], to = polygon.points[(side + 1) % polygon.points.size()];
  const auto at = static_cast<std::ptrdiff_t>(side) + 1;
  const bool was_usable = is_usable(polygon, tile);
  const Vec2 on_side = nearest_between(from, to, place);
  polygon.points.insert(polygon.points.begin() + at, weld(on_side));
  for (const Vec2 wanted : {snapped(on_side, snap, tile), snapped(on_side, PointSnap::pixels, tile)}) {
    TileShape tried = with_point_at(polygon, side + 1, wanted, tile);
    const bool is_apart = tried.points[side + 1] != from && tried.points[side + 1] != to;
    if (is_apart && (!was_usable || is_usable(tried, tile))) return tried;
  }
  return polygon;
}

TileShape without_point(TileShape polygon, std::size_t point) {
  assert(point < polygon.points.size());
  polygon.points.erase(polygon.points.begin() + static_cast<std::ptrdiff_t>(point));
  return polygon;
}

TileShape moved_by(TileShape polygon, Vec2 by, TileSize tile) {
  for (const Vec2 point : polygon.points) by = kept_near(point + by, tile) - point;
  for (Vec2& point : polygon.points) point = weld(point + by);
  return polygon;
}

std::size_t part_count(const TileShape& shape) {
  if (shape.kind == Kind::group) return shape.parts.size();
  return shape.kind == Kind::none ? 0 : 1;
}

const TileShape& part_at(const TileShape& shape, std::size_t part) {
  assert(part < part_count(shape));
  return shape.kind == Kind::group ? shape.parts[part] : shape;
}

TileShape with_part_at(const TileShape& shape, std::size_t part, const TileShape& replacement) {
  assert(part < part_count(shape));
  if (shape.kind != Kind::group) return replacement;
  TileShape all;
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    all = with_new_part(all, i == part ? replacement : shape.parts[i]);
  all.conveyor = shape.conveyor;
  return all;
}

TileShape with_new_part(const TileShape& shape, const TileShape& part) {
  std::vector<TileShape> parts;
  for (const TileShape* from : {&shape, &part})
    for (std::size_t i = 0; i < part_count(*from); ++i) parts.push_back(part_at(*from, i));
  if (parts.empty()) return {};
  // A group is a conveyor as a whole.
  for (TileShape& one : parts) one.conveyor = 0;
  TileShape all = parts.size() == 1 ? std::move(parts.front())
                                    : TileShape{.kind = Kind::group, .parts = std::move(parts)};
  all.conveyor = shape.conveyor != 0 ? shape.conveyor : part.conveyor;
  return all;
}

std::optional<std::size_t> part_near(const TileShape& shape, TileSize tile, Vec2 place, double reach) {
  for (std::size_t i = part_count(shape); i-- > 0;) {
    const TileShape polygons = as_polygon(part_at(shape, i), tile);
    for (std::size_t k = 0; k < part_count(polygons); ++k) {
      TileShape polygon = part_at(polygons, k);
      if (side_near(polygon.points, place, reach)) return i;
      polygon.one_way = false;
      if (is_in_ground(polygon, tile, place)) return i;
    }
  }
  return std::nullopt;
}

}  // namespace talus
