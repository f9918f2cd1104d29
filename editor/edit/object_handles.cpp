// Boxes are dragged in their own frame, which is turned about their place.
#include "object_handles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <talus/collision/shape.h>
#include "distance_to_line.h"

namespace talus {
namespace {

using Form = MapObject::Form;

bool has_corners(const MapObject& object) {
  return (object.form == Form::box || object.form == Form::ellipse) && object.size != Vec2();
}

Vec2 turned(Vec2 v, double degrees) {
  if (degrees == 0) return v;
  const double angle = degrees * std::numbers::pi / 180;
  return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

bool is_inside(const std::vector<Vec2>& outline, Vec2 at) {
  bool inside = false;
  for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
    const Vec2 a = outline[i], b = outline[k];
    if ((a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x)
      inside = !inside;
  }
  return inside;
}

// A box that has all of the object, however it is turned.
bool may_have(const MapObject& object, Vec2 at, double reach) {
  double most = object.size.x + object.size.y + reach;
  for (const Vec2 p : object.points) most = std::max(most, std::abs(p.x) + std::abs(p.y) + reach);
  return std::abs(at.x - object.position.x) <= most && std::abs(at.y - object.position.y) <= most;
}

bool has_point(const MapObject& object, Vec2 at, double reach) {
  if (!may_have(object, at, reach)) return false;
  const std::vector<Vec2> outline = outline_of(object);
  if (!outline.empty() && is_inside(outline, at)) return true;
  const std::vector<Vec2> line = outline.empty() ? line_of(object) : outline;
  const std::size_t sides = line.size() - (outline.empty() && !line.empty() ? 1 : 0);
  for (std::size_t i = 0; i < sides; ++i)
    if (distance_to_line(line[i], line[(i + 1) % line.size()], at) <= reach) return true;
  if (object.form == Form::tile && is_inside(frame_of(object), at)) return true;
  return line.empty() && std::hypot(at.x - object.position.x, at.y - object.position.y) <= reach;
}

}  // namespace

std::string_view label_of(ObjectKind kind) {
  constexpr std::array<std::string_view, kObjectKindCount> kLabels = {"rectangle", "ellipse", "polygon",
                                                                      "point"};
  return kLabels[static_cast<std::size_t>(kind)];
}

std::vector<Vec2> handles_of(const MapObject& object) {
  std::vector<Vec2> handles;
  if (has_corners(object)) {
    for (const Vec2 share : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
      handles.push_back(object.position +
                        turned({share.x * object.size.x, share.y * object.size.y}, object.rotation));
  }
  for (const Vec2 p : object.points) handles.push_back(object.position + turned(p, object.rotation));
  return handles;
}

MapObject with_handle(MapObject object, int handle, Vec2 place) {
  const std::vector<Vec2> handles = handles_of(object);
  const auto i = static_cast<std::size_t>(handle);
  assert(handle >= 0 && i < handles.size());
  if (!object.points.empty()) {
    object.points[i] = weld(turned(place - object.position, -object.rotation));
    return object;
  }
  const Vec2 fixed = handles[(i + 2) % 4];
  const Vec2 across = turned(place - fixed, -object.rotation);
  object.size = weld(Vec2{std::abs(across.x), std::abs(across.y)});
  object.position = weld(fixed + turned({std::min(across.x, 0.0), std::min(across.y, 0.0)}, object.rotation));
  return object;
}

MapObject moved_object(MapObject object, Vec2 by) {
  object.position = object.position + by;
  return object;
}

std::vector<Vec2> frame_of(const MapObject& object) {
  std::vector<Vec2> corners;
  if (object.form != Form::tile) return corners;
  for (const Vec2 share : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
    const Vec2 from = share - object.anchor;
    corners.push_back(object.position +
                      turned({from.x * object.size.x, from.y * object.size.y}, object.rotation));
  }
  return corners;
}

std::vector<Vec2> middles_of(const MapObject& object) {
  std::vector<Vec2> middles;
  if (object.points.size() < 2) return middles;
  const std::vector<Vec2> points = handles_of(object);
  const std::size_t sides = points.size() - (object.form == Form::polyline ? 1 : 0);
  for (std::size_t i = 0; i < sides; ++i)
    middles.push_back((points[i] + points[(i + 1) % points.size()]) * 0.5);
  return middles;
}

MapObject with_point_after(MapObject object, int side, Vec2 place) {
  assert(side >= 0 && static_cast<std::size_t>(side) < object.points.size());
  object.points.insert(object.points.begin() + side + 1,
                       weld(turned(place - object.position, -object.rotation)));
  return object;
}

MapObject without_point(MapObject object, int point) {
  assert(point >= 0 && static_cast<std::size_t>(point) < object.points.size());
  const std::size_t least = object.form == Form::polyline ? 2 : 3;
  if (object.points.size() > least) object.points.erase(object.points.begin() + point);
  return object;
}

Vec2 offset_of_layer(const Level& level, int layer) {
  const bool is_there = layer >= 0 && layer < static_cast<int>(level.objects.size());
  if (!is_there) return {};
  return shown_looks(level.layers.groups, level.objects[static_cast<std::size_t>(layer)]).offset;
}

ObjectRef object_at(const Level& level, Vec2 point, double reach) {
  for (int layer = static_cast<int>(level.objects.size()) - 1; layer >= 0; --layer) {
    if (problem_of_layer(level, layer)) continue;
    const ObjectLayer& its = level.objects[static_cast<std::size_t>(layer)];
    const Vec2 at = point - offset_of_layer(level, layer);
    for (int i = static_cast<int>(its.objects.size()) - 1; i >= 0; --i)
      if (has_point(its.objects[static_cast<std::size_t>(i)], at, reach)) return {layer, i};
  }
  return {};
}

MapObject object_between(MapObject::Form form, Vec2 from, Vec2 to) {
  MapObject object;
  object.form = form;
  object.position = {std::min(from.x, to.x), std::min(from.y, to.y)};
  object.size = {std::abs(from.x - to.x), std::abs(from.y - to.y)};
  return object;
}

MapObject polygon_through(const std::vector<Vec2>& corners) {
  assert(!corners.empty());
  MapObject object;
  object.form = Form::polygon;
  object.position = corners.front();
  for (const Vec2 corner : corners) object.points.push_back(corner - object.position);
  return object;
}

}  // namespace talus
