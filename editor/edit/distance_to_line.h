// The distance of a point from a line, for tools that pick what is near the mouse.
#pragma once

#include <algorithm>
#include <cmath>

#include <talus/collision/geometry.h>

namespace talus {

// px, from a point to the nearest place of the straight line between two points, which may be the same.
inline double distance_to_line(Vec2 from, Vec2 to, Vec2 point) {
  const Vec2 along = to - from, way = point - from;
  const double squared = dot(along, along);
  const double part = squared > 0 ? std::clamp(dot(way, along) / squared, 0.0, 1.0) : 0;
  return std::hypot(way.x - along.x * part, way.y - along.y * part);
}

}  // namespace talus
