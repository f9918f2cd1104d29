#include <talus/level/object_layer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {
namespace {

std::vector<Vec2> ellipse_in(Vec2 size) {
  constexpr double kError = 1.0 / 256;  // px
  constexpr int kMaxSides = 1024;
  const Vec2 radius{size.x / 2, size.y / 2};
  const double longest = std::max(radius.x, radius.y);
  const double angle = longest <= kError ? 1 : std::acos(1 - kError / longest);
  const int quarter = std::clamp(static_cast<int>(std::ceil(std::numbers::pi / angle / 4)), 2, kMaxSides / 4);
  std::vector<Vec2> points;
  for (int i = 0; i < 4 * quarter; ++i) {
    // Quarters are mirror images of one another, to the bit.
    const int part = i % quarter, turn = i / quarter;
    const double at = std::numbers::pi / 2 * part / quarter;
    const Vec2 on = part == 0 ? Vec2{1, 0} : Vec2{std::cos(at), std::sin(at)};
    const Vec2 unit = turn == 0   ? on
                      : turn == 1 ? Vec2{-on.y, on.x}
                      : turn == 2 ? Vec2{-on.x, -on.y}
                                  : Vec2{on.y, -on.x};
    points.push_back({radius.x + radius.x * unit.x, radius.y + radius.y * unit.y});
  }
  return points;
}

std::vector<Vec2> placed(std::vector<Vec2> points, const MapObject& object) {
  const double angle = object.rotation * std::numbers::pi / 180;
  const Vec2 right = object.rotation == 0 ? Vec2{1, 0} : Vec2{std::cos(angle), std::sin(angle)};
  for (Vec2& p : points)
    p = object.position + Vec2{p.x * right.x - p.y * right.y, p.x * right.y + p.y * right.x};
  return points;
}

}  // namespace

std::vector<Vec2> outline_of(const MapObject& object) {
  const Vec2 size = object.size;
  const bool has_size = size.x > 0 && size.y > 0;
  if (object.form == MapObject::Form::polygon) return placed(object.points, object);
  if (object.form == MapObject::Form::ellipse && has_size) return placed(ellipse_in(size), object);
  if (object.form != MapObject::Form::box || !has_size) return {};
  return placed({{0, 0}, {size.x, 0}, size, {0, size.y}}, object);
}

std::vector<Vec2> line_of(const MapObject& object) {
  return object.form == MapObject::Form::polyline ? placed(object.points, object) : std::vector<Vec2>();
}

}  // namespace talus
