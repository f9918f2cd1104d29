// Computes zoom and scroll positions.
#include "camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

// Far enough for the longest map.
constexpr std::array<float, 25> kZooms = {1.0f / 32768,
                                          1.0f / 16384,
                                          1.0f / 8192,
                                          1.0f / 4096,
                                          1.0f / 2048,
                                          1.0f / 1024,
                                          1.0f / 512,
                                          1.0f / 256,
                                          1.0f / 128,
                                          1.0f / 64,
                                          1.0f / 32,
                                          1.0f / 16,
                                          0.125f,
                                          0.25f,
                                          0.5f,
                                          1,
                                          2,
                                          3,
                                          4,
                                          5,
                                          6,
                                          8,
                                          10,
                                          12,
                                          16};
constexpr int kQuarter = 13;         // the step of 1/4
constexpr double kKeptInSight = 48;  // px of the screen
constexpr float kLeastFitted = 96;   // px of the screen: in a smaller canvas nothing can be seen

int step_that_fits(Vec2 level, ImVec2 canvas) {
  int step = 0;
  for (std::size_t i = 0; i < kZooms.size(); ++i)
    if (level.x * kZooms[i] <= canvas.x && level.y * kZooms[i] <= canvas.y) step = static_cast<int>(i);
  return step;
}

}  // namespace

Cell CanvasView::to_cell(ImVec2 p) const {
  const Vec2 at = to_level(p);
  return {static_cast<int>(std::floor(at.x / tile.width)), static_cast<int>(std::floor(at.y / tile.height))};
}

Rect CanvasView::visible() const {
  const Vec2 from = to_level(min), to = to_level(max);
  return {from.x, from.y, to.x - from.x, to.y - from.y};
}

float Camera::zoom() const { return kZooms[static_cast<std::size_t>(step_)]; }

void Camera::zoom_at(ImVec2 at, int steps) {
  untouched_ = false;
  const double before = zoom();
  const int step = std::clamp(step_ + steps, least_, static_cast<int>(kZooms.size()) - 1);
  if (step == step_) return;
  step_ = step;
  before_.reset();
  const double ratio = zoom() / before;
  offset_ = {std::round(at.x - (at.x - offset_.x) * ratio), std::round(at.y - (at.y - offset_.y) * ratio)};
}

void Camera::scroll(Vec2 pixels) {
  if (pixels == Vec2{}) return;
  untouched_ = false;
  offset_ = offset_ - pixels;
}

void Camera::centre(Vec2 point, ImVec2 canvas) {
  untouched_ = false;
  offset_ = {std::round(canvas.x / 2 - point.x * zoom()), std::round(canvas.y / 2 - point.y * zoom())};
}

Vec2 Camera::missing(Vec2 point, ImVec2 canvas) const {
  const auto along = [](double at, double size) {
    const double room = std::min(kKeptInSight, size / 4);
    return std::round(at - std::clamp(at, room, size - room));
  };
  return {along(offset_.x + point.x * zoom(), canvas.x), along(offset_.y + point.y * zoom(), canvas.y)};
}

bool Camera::is_in_sight(Vec2 point, ImVec2 canvas) const {
  return !shows_whole() && missing(point, canvas) == Vec2{};
}

void Camera::keep_in_sight(Vec2 point, ImVec2 canvas) {
  if (!shows_whole()) scroll(missing(point, canvas));
}

void Camera::fit(Vec2 level, ImVec2 canvas) {
  step_ = step_that_fits(level, {std::max(canvas.x, kLeastFitted), std::max(canvas.y, kLeastFitted)});
  centre(level * 0.5, canvas);
  untouched_ = true;
}

void Camera::toggle_whole(Vec2 map, ImVec2 canvas) {
  if (before_) {
    step_ = before_->step;
    offset_ = before_->offset;
    before_.reset();
  } else {
    before_ = Place{step_, offset_};
    fit(map, canvas);
    untouched_ = false;
  }
}

void Camera::leave_whole(Vec2 point, ImVec2 canvas) {
  if (before_) step_ = before_->step;
  before_.reset();
  centre(point, canvas);
}

void Camera::limit(Vec2 map, ImVec2 canvas) { least_ = std::min(kQuarter, step_that_fits(map, canvas)); }

void Camera::clamp(Vec2 map, ImVec2 canvas) {
  offset_.x = std::clamp(offset_.x, kKeptInSight - map.x * zoom(), canvas.x - kKeptInSight);
  offset_.y = std::clamp(offset_.y, kKeptInSight - map.y * zoom(), canvas.y - kKeptInSight);
}

CanvasView Camera::view(ImVec2 min, ImVec2 size, TileSize tile) const {
  return {min,
          {min.x + size.x, min.y + size.y},
          {min.x + std::round(offset_.x), min.y + std::round(offset_.y)},
          zoom(),
          tile};
}

}  // namespace talus
